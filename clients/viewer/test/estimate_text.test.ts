// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import type { PredictedRun } from '../src/api/messages';
import { estimateText } from '../src/editor/estimate_text';
import { roughTime } from '../src/scene/number_text';

const asItIs: PredictedRun = { wall_s: 12.43, steps: '1480', basis: 'FIRST_MOMENTS', until_s: 0.0125 };
const toTolerance: PredictedRun[] = [
  { tolerance_m: 1e-3, wall_s: 27.69, steps: '1314', basis: 'FIRST_MOMENTS', until_s: 0.01333333, basis_tolerance_m: 0.01 },
  { tolerance_m: 1e-4, wall_s: 900, steps: '13140', basis: 'FIRST_MOMENTS', until_s: 0.01333333, basis_tolerance_m: 0.01 },
];
const prediction = { unknowns: 2412, memory_bytes: '40400000', as_it_is: asItIs, to_tolerance: toTolerance };

describe('estimateText', () => {
  it('tells size and time in one line, and the times to tolerances', () => {
    const { line, times, fails } = estimateText(prediction);
    expect(line).toBe('2,412 unknowns · about 40 MB · about 12 s');
    expect(times).toEqual([['As it is', 'about 12 s, 1,480 steps'], ['To 1 mm', 'about 28 s, 1,314 steps'], ['To 0.1 mm', 'about 15 min, 13,140 steps']]);
    expect(fails).toBe('');
  });
  it('tells what times rest on', () => {
    expect(estimateText(prediction).basis).toBe('The time of the scene as it is rests on the first 0.0125 s, tried by the server. '
      + 'Times to a tolerance rest on the first 0.0133 s, tried by the server, run to 10 mm. On the server’s machine, with one thread; most are within a factor of two.');
    const canned = { ...prediction, as_it_is: { ...asItIs, basis: 'CANNED_RUN' as const }, to_tolerance: [{ ...toTolerance[0], basis: 'CANNED_RUN' as const }] };
    expect(estimateText(canned).basis).toMatch(/^All times rest on how a small swatch runs on the server, as there was no time to try this scene\. On/);
    expect(estimateText({ ...prediction, as_it_is: { wall_s: 1, basis: 'WHOLE_RUN' }, to_tolerance: [] }).basis).toMatch(/^The time of the scene as it is rests on the whole run/);
  });
  it('does not say of a scene that was tried that it was not', () => {
    const others = { ...prediction, to_tolerance: [{ ...toTolerance[0], basis: 'CANNED_RUN' as const }] };
    expect(estimateText(others).basis).toMatch(/^The time of the scene as it is rests on the first 0.0125 s, tried by the server\. Times to a tolerance rest on how a small swatch runs on the server, as there was no time to try this scene to a tolerance\./);
    expect(estimateText({ ...others, run_fails: 'no step is short enough' }).basis).toMatch(/^Times to a tolerance rest on how a small swatch runs on the server\./);
    expect(estimateText({ unknowns: 1, memory_bytes: '1', run_fails: 'no step is short enough' }).basis).toBe('');
  });
  it('tells of a choice of effects, whose time is not known', () => {
    const { line, choice } = estimateText({ ...prediction, chooses_effects: true });
    expect(line).toBe('2,412 unknowns · about 40 MB · about 12 s and the choice of effects before it');
    expect(choice).toMatch(/with and without effects, which can take longer than the run/);
    expect(estimateText(prediction).choice).toBe('');
    expect(estimateText({ ...prediction, as_it_is: undefined, chooses_effects: true }).line).toMatch(/MB · the choice of effects before it$/);
    expect(estimateText({ ...prediction, run_fails: 'no', chooses_effects: true }).line).toMatch(/ · fails at its start$/);
  });
  it('leaves out times that are not known', () => {
    const { line, times, basis } = estimateText({ unknowns: 1, memory_bytes: '2340000000' });
    expect([line, times]).toEqual(['1 unknown · about 2.3 GB', []]);
    expect(basis).toBe('How long it takes is not known before it is run.');
  });
  it('tells of a run that fails rather than how long it takes', () => {
    const { line, times, fails } = estimateText({ ...prediction, run_fails: 'no step is short enough' });
    expect(line).toBe('2,412 unknowns · about 40 MB · fails at its start');
    expect(fails).toBe('no step is short enough');
    expect(times[0][0]).toBe('To 1 mm');
  });
  it('gives rough times', () => {
    expect([0.42, 9.96, 66.2, 95, 916, 5399, 9000, 130_000, 1e6].map(roughTime)).toEqual(['0.42 s', '10 s', '66 s', '1.6 min', '15 min', '90 min', '2.5 h', '1.5 days', '12 days']);
    expect(estimateText({ ...prediction, as_it_is: { wall_s: 0.004 } }).line).toMatch(/less than 0.1 s$/);
  });
});
