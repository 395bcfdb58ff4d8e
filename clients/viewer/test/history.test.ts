// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { parseHistory, plotsOf } from '../src/plots/history';
import { line } from '../src/plots/plot';
import { logTicks, ticks } from '../src/plots/ticks';

const text = `frame,t_s,steps,rejected_steps,newton_iterations,linear_iterations,step_s,residual,error_estimate_m,kinetic_j,stretch_j,sliding_friction_j
0,0,0,0,0,0,,,,0,1e-6,0
1,0.1,4,0,20,0,0.025,1e-5,,2e-6,3e-6,0
2,0.2,8,1,50,0,0.0125,2e-5,,1e-6,4e-6,0
3,0.3,12,1,6`;

describe('history.csv', () => {
  const history = parseHistory(text);
  it('leaves the torn last line out', () => {
    expect(history.rows).toBe(3);
    expect(history.values.get('t_s')).toEqual([0, 0.1, 0.2]);
  });
  it('knows cells that were not measured', () => expect(history.values.get('step_s')).toEqual([NaN, 0.025, 0.0125]));
  it('is empty while it has no line', () => expect(parseHistory('frame,t_s')).toEqual({ columns: [], values: new Map(), rows: 0 }));

  const plots = plotsOf(history);
  it('plots what was measured, energies that are not all zero', () => {
    expect(plots.map((plot) => plot.title)).toEqual(['Energy by effect', 'Step size', 'Newton iterations a frame']);
    expect(plots[0].series.map((series) => series.name)).toEqual(['kinetic', 'stretch']);
  });
  it('shows energies as change since the start', () => {
    const [energies] = plotsOf(history, true);
    expect(energies.series[1].y.map((value) => Math.round(1e6 * value))).toEqual([0, 2, 3]);
  });
  it('draws a point that stands alone', () => {
    const axis = { place: (value: number) => value };
    const path = (y: number[]): string => line({ ...plots[0], x: [1, 2, 3, 4], logarithmic: false }, { name: 'y', term: '', y }, axis, axis);
    expect(path([NaN, 5, NaN, NaN])).toBe('M2.0 5.0m-2 0a2 2 0 1 0 4 0a2 2 0 1 0 -4 0');
    expect(path([NaN, 5, 6, NaN])).toBe('M2.0 5.0L3.0 6.0');
    expect(path([NaN, NaN, NaN, 5])).toMatch(/^M4\.0 5\.0m.*a/);
  });
  it('counts iterations a frame', () => expect(plots[2].series[0].y).toEqual([0, 20, 30]));
});

describe('ticks', () => {
  it('are round', () => {
    expect(ticks(0, 1, 5)).toEqual([0, 0.2, 0.4, 0.6, 0.8, 1]);
    expect(ticks(-5e-5, 5e-5, 4)).toEqual([-5e-5, 0, 5e-5]);
    expect(ticks(1, 1, 4)).toEqual([1]);
  });
  it('are powers of ten on logarithmic axes, or round within a decade', () => {
    expect(logTicks(0.5e-3, 2, 4)).toEqual([1e-3, 1e-2, 1e-1, 1]);
    expect(logTicks(1e-9, 1, 4)).toHaveLength(4);
    expect(logTicks(2e-3, 6e-3, 4).length).toBeGreaterThan(1);
  });
});
