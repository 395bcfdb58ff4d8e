// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { chartFromText, copyRows, courseOfRow, paint, paintLine, pasteRows, repeat, repeatProblem, resize, sizeProblem, swapStitches } from '../src/chart/chart';
import { chartOfKnit } from '../src/chart/knit_chart';
import { presetChart } from '../src/chart/presets';
import type { Json } from '../src/scene/field';

describe('chart', () => {
  const chart = ['KPK', 'KKK', 'PPP'];

  it('counts courses from the last row', () => expect([0, 1, 2].map((row) => courseOfRow(chart, row))).toEqual([3, 2, 1]));
  it('paints one stitch and leaves the others', () => expect(paint(chart, { row: 1, column: 2 }, 'P')).toEqual(['KPK', 'KKP', 'PPP']));
  it('is the same where nothing changes', () => {
    expect(paint(chart, { row: 0, column: 1 }, 'P')).toBe(chart);
    expect(paint(chart, { row: 9, column: 1 }, 'P')).toBe(chart);
  });
  it('paints lines without gaps', () => {
    expect(paintLine(['KKKK', 'KKKK', 'KKKK'], { row: 0, column: 0 }, { row: 2, column: 3 }, 'P').join('').replaceAll('K', '')).toHaveLength(4);
  });
  it('grows and shrinks at the top and at the right', () => {
    expect(resize(chart, 4, 4)).toEqual(['KKKK', 'KPKK', 'KKKK', 'PPPK']);
    expect(resize(chart, 2, 2)).toEqual(['KK', 'PP']);
  });
  it('repeats up and across', () => expect(repeat(['KP', 'PP'], 2, 3)).toEqual(['KPKPKP', 'PPPPPP', 'KPKPKP', 'PPPPPP']));
  it('says which sizes there can be', () => {
    expect(['2', '400'].map(sizeProblem)).toEqual([undefined, undefined]);
    expect(sizeProblem('')).toBe('is empty, expected a whole number from 2 to 400');
    for (const typed of ['0', '-3', '1', '401', '2.5', '1e9', 'x', '0x10', '1,000', '1 0']) expect(sizeProblem(typed)).toMatch(`is ${typed}, expected a whole number from 2 to 400`);
  });
  it('says how often there is room', () => {
    expect(['1', '40'].map((typed) => repeatProblem(typed, 10))).toEqual([undefined, undefined]);
    expect(repeatProblem('41', 10)).toBe('is 41, expected a whole number from 1 to 40, as a chart has at most 400');
    for (const typed of ['', '0', '1.5', '-1']) expect(repeatProblem(typed, 10)).toMatch(/expected a whole number from 1 to 40/);
  });
  it('pastes rows upwards from a row, as wide as the chart', () => {
    const rows = copyRows(['PPP', 'PKP'], 1, 0);
    expect(pasteRows(['KKKK', 'KKKK', 'KKKK'], rows, 1)).toEqual(['PPPP', 'PKPP', 'KKKK']);
    expect(pasteRows(['KKK', 'KKK'], rows, 0)).toEqual(['PKP', 'KKK']);
  });
  it('swaps', () => expect(swapStitches(['KPK'])).toEqual(['PKP']));
  it('reads text, or says what is wrong with it', () => {
    expect(chartFromText(' kp \n\nPK')).toEqual(['KP', 'PK']);
    expect(chartFromText('KP\nKPX')).toMatch(/X in line 2, column 3/);
    expect(chartFromText('KP\nK')).toMatch(/1 stitches in line 2, expected 2/);
    expect(chartFromText('KP')).toMatch(/1 rows/);
  });
});

describe('presets', () => {
  const preset = (name: string, ribKnits = 1, ribPurls = 1): readonly string[] => presetChart({ name, courses: 2, wales: 4, ribKnits, ribPurls });
  it('are those of the schema', () => {
    expect(preset('stockinette')).toEqual(['KKKK', 'KKKK']);
    expect(preset('reverse_stockinette')).toEqual(['PPPP', 'PPPP']);
    expect(preset('garter')).toEqual(['PPPP', 'KKKK']);
    expect(preset('rib', 2, 2)).toEqual(['KKPP', 'KKPP']);
    expect(preset('seed')).toEqual(['PKPK', 'KPKP']);
  });
});

describe('chartOfKnit', () => {
  it('reads charts and presets', () => {
    expect(chartOfKnit({ chart: { rows: ['kp', 'PK'] } })).toEqual(['KP', 'PK']);
    expect(chartOfKnit({ preset: { name: 'rib', courses: 2, wales: 3 } })).toEqual(['KPK', 'KPK']);
  });
  it('reads worked rows: odd ones from the right, even ones of flat pieces on the wrong side', () => {
    expect(chartOfKnit({ worked_rows: { rows: ['KPP', 'KKP'] } })).toEqual(['PPK', 'PPK']);
    expect(chartOfKnit({ worked_rows: { rows: ['KPP', 'KKP'] }, in_the_round: true })).toEqual(['PKK', 'PPK']);
  });
  it.each<[Json | undefined, string]>([
    [{ chart: { rows: ['KQ', 'KK'] } }, 'knit.chart.rows[0] has Q at stitch 2, expected K or P'],
    [{ chart: { rows: ['KK', 'KKK'] } }, 'knit.chart.rows[1] has 3 stitches, expected 2 as in the first row'],
    [{ chart: { rows: ['', ''] } }, 'knit.chart.rows[0] has no stitch'],
    [{ chart: { rows: [] } }, 'knit.chart has no rows'],
    [{ chart: {} }, 'knit.chart has no rows'],
    [{ chart: { rows: 'KK' } }, 'knit.chart.rows is "KK", expected rows of K and P'],
    [{ chart: { rows: [null, null] } }, 'knit.chart.rows[0] is null, expected a row of K and P'],
    [{ chart: null }, 'knit.chart is null, expected an object'],
    [{ worked_rows: { rows: ['K', null] } }, 'knit.worked_rows.rows[1] is null, expected a row of K and P'],
    [{ worked_rows: 'KK' }, 'knit.worked_rows is "KK", expected an object'],
    [{ preset: { name: 'rib', courses: 1e9, wales: 3 } }, 'knit.preset.courses is 1000000000, expected a whole number from 1 to 400'],
    [{ preset: { name: 'rib', courses: 2, wales: '3' } }, 'knit.preset.wales is "3", expected a whole number from 1 to 400'],
    [{ preset: { name: 'rib', courses: 2, wales: 3, rib_purls: {} } }, 'knit.preset.rib_purls is {}, expected a whole number'],
    [{ preset: { name: 7, courses: 2, wales: 3 } }, 'knit.preset.name is 7, expected a name'],
    [{ preset: { name: 'cable', courses: 2, wales: 3 } }, 'knit.preset.name is "cable", expected stockinette,'],
    [{ preset: [] }, 'knit.preset is [], expected an object'],
    [{}, 'knit has no chart, preset or worked_rows'],
    [3, 'knit is 3, expected an object'],
    [undefined, 'there is no knit'],
  ])('says why it cannot draw %j', (knit, why) => {
    const chart = chartOfKnit(knit);
    expect(typeof chart === 'string' && chart.startsWith(why) ? why : chart).toBe(why);
  });
});
