// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { rowsOfStitch } from '../src/jobs/stitch_panel';
import type { PlotData } from '../src/plots/history';
import { describePlot } from '../src/plots/plot';
import { shortNumber } from '../src/scene/number_text';

describe('shortNumber', () => {
  it('writes 0 for what is smaller than is resolved, without a sign', () => {
    expect([-6.64e-16, 6.64e-16, -9.99e-4, -0].map((value) => shortNumber(value, 1e-3))).toEqual(['0', '0', '0', '0']);
    expect([1e-3, -1.5].map((value) => shortNumber(value, 1e-3))).toEqual(['0.001', '-1.5']);
  });
});

describe('numbers that are rounding only', () => {
  it('read 0 of a stitch', () => {
    const rows = rowsOfStitch({ course: 1, wale: 1, kind: 'knit', meanStretch: 2e-17, mostTension: -3e-15, slid: -4e-19, length: 0.01,
      wraps: [{ where: 'base left', angle: -1.16e-17 }, { where: 'base right', angle: NaN }] });
    expect(rows.map(([, value]) => value)).toEqual(['0 %', '0 mN', '0°', '–', '0 mm', '10 mm']);
  });
  it('read 0 beside the others of a plot', () => {
    const plot: PlotData = { title: 'Energy', unit: 'J', x: [0, 1], logarithmic: false,
      series: [{ name: 'gravity', term: 'gravity', y: [0, -1.2e-23] }, { name: 'bending', term: 'bending', y: [0, 2e-6] }] };
    expect(describePlot(plot)).toBe('Energy over 1 s. At the end: gravity 0 J, bending 2.00e-6 J.');
    expect(describePlot({ ...plot, logarithmic: true, series: [{ name: 'error', term: '', y: [1, 1e-9] }] })).toMatch(/error 1\.00e-9 J/);
  });
});
