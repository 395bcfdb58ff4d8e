// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { lengthFactor, slidLengths, strains, visitMeans, wrapAngles } from '../src/fabric/derive';
import { contactWraps, rangeOf, valuesOfVisits } from '../src/fabric/quantities';
import { shortNumber } from '../src/scene/number_text';
import { exportedFrame, goldenRun } from './golden';

const { fabric, frames } = goldenRun();

function closeTo(actual: ArrayLike<number>, expected: readonly (number | null)[], tolerance: number): void {
  expect(actual.length).toBe(expected.length);
  expected.forEach((value, index) => {
    if (value === null) expect(actual[index]).toBeNaN();
    else expect(Math.abs(actual[index] - value), `at ${index}`).toBeLessThan(tolerance);
  });
}

describe.each([0, 2])('frame %i, as the exporter wrote it', (index) => {
  const frame = frames[index];
  const exported = exportedFrame(index);

  it('has the same points', () => {
    const points = exported.yarns.flatMap((yarn) => yarn.points_m.flat());
    const ours = Array.from(fabric.visitNode).flatMap((node) => Array.from(frame.q.subarray(3 * node, 3 * node + 3)));
    expect(ours).toEqual(points);
  });
  it('has the same tensions', () => {
    const tensions = visitMeans(fabric, strains(fabric, frame)).map((strain) => fabric.stretch * strain);
    closeTo(tensions, exported.yarns.flatMap((yarn) => yarn.tension_n), 1e-12);
  });
  it('has the same wrap angles', () => closeTo(wrapAngles(fabric, frame), exported.wrap_rad.flat(), 1e-12));
  it('has slid as far', () => closeTo(slidLengths(fabric, frame, frames[0]), exported.yarns.flatMap((yarn) => yarn.slid_m), 1e-15));
});

describe('quantities', () => {
  it('gives one value a visit, in its unit', () => {
    const exported = exportedFrame(2);
    closeTo(valuesOfVisits('tension', fabric, frames[2], frames[0]), exported.yarns.flatMap((yarn) => yarn.tension_n.map((value) => 1000 * value)), 1e-9);
    closeTo(valuesOfVisits('slid', fabric, frames[2], frames[0]), exported.yarns.flatMap((yarn) => yarn.slid_m.map((value) => 1000 * value)), 1e-12);
    expect(valuesOfVisits('wrap', fabric, frames[2], frames[0]).some((value) => Math.abs(value) > 1)).toBe(true);
  });

  it('signs the wrap of a contact by what drives it', () => {
    const angles = wrapAngles(fabric, frames[2]);
    const wraps = contactWraps(fabric, frames[2]);
    const index = fabric.contacts.findIndex((contact, at) => contact.sign === -1 && !Number.isNaN(angles[2 * at] + angles[2 * at + 1]));
    expect(wraps[index]).toBeCloseTo(-(angles[2 * index] + angles[2 * index + 1]) / 2, 12);
  });

  it('has a range around zero where signs matter, and never an empty one', () => {
    expect(rangeOf(Float64Array.of(-1, 3, NaN), true)).toEqual([-3, 3]);
    expect(rangeOf(Float64Array.of(0, 0), true)).toEqual([-1e-6, 1e-6]);
    expect(rangeOf(Float64Array.of(-1, 3, NaN), false)).toEqual([-1, 3]);
    expect(rangeOf(Float64Array.of(NaN), false)).toEqual([0, 1]);
    const [low, high] = rangeOf(Float64Array.of(2, 2), false);
    expect(high).toBeGreaterThan(low);
  });

  it.each([[[-6e-16, 3e-15], false], [[-9e-4, 8e-4], false], [[-9e-4, 1.05e-3], false], [[-6e-16, 3e-15], true]])(
    'has ends that read differently where all is below what is resolved: %j', (values, diverging) => {
      const [low, high] = rangeOf(Float64Array.from(values), diverging, 1e-3).map((end) => Number(shortNumber(end, 1e-3)));
      expect(low).toBeLessThan(high);
    });
});

describe('lengthFactor', () => {
  const keyframes = [{ t: 1, factor: 0.8 }, { t: 2, factor: 0.6 }];
  it.each([[0, 1], [0.5, 0.9], [1, 0.8], [1.5, 0.7], [5, 0.6]])('at %f s is %f', (t, factor) => {
    expect(lengthFactor(keyframes, t)).toBeCloseTo(factor, 12);
  });
  it('is 1 without shrinkage', () => expect(lengthFactor([], 3)).toBe(1));
});
