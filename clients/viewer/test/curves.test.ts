// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { capPoints, planCurves } from '../src/draw/curve_plan';
import { makeCurveBuffers, noValue, pointLengths, pointThickness, traceCurves, visitOfPoint } from '../src/draw/curves';
import { pickPoint } from '../src/draw/pick';
import { planPosts } from '../src/fabric/posts';
import { separateContact } from '../src/fabric/separate';
import { norm, sub, vec3At } from '../src/fabric/vec3';
import { goldenRun } from './golden';

const { fabric, frames } = goldenRun();
const frame = frames[2];
const plan = planCurves(fabric);
const buffers = makeCurveBuffers(plan);
traceCurves(fabric, plan, frame.q, new Float64Array(fabric.numVisits).fill(NaN), buffers);
const again = makeCurveBuffers(plan);

/// Of every drawn point the smallest distance, in diameters, to yarn that is more than 2.25 diameters of yarn away.
function nearestTurns(points: Float32Array): number[] {
  const diameter = 2 * fabric.radius;
  const lengths = pointLengths(plan, points);
  const drawn = [...lengths.keys()].filter((point) => lengths[point] >= 0);
  return drawn.map((one) => Math.min(...drawn.map((other) => (Math.abs(lengths[other] - lengths[one]) < 2.25 * diameter
    ? Infinity : norm(sub(vec3At(points, 4 * one), vec3At(points, 4 * other))) / diameter))));
}

describe('curves', () => {
  it('go through one point a visit and three more within every contact of a yarn', () => {
    expect(plan.numControls).toBe(fabric.numVisits + 2 * 3 * fabric.contacts.length);
    expect(buffers.points.length).toBe(4 * plan.numPoints);
    expect([...buffers.points].every(Number.isFinite)).toBe(true);
  });

  it('leave visits between loops where they are', () => {
    const ofPosts = new Set(planPosts(fabric).flat().flatMap(({ low, high }) => [low, high]));
    for (let visit = 0; visit < fabric.numVisits; ++visit) {
      if (ofPosts.has(fabric.visitNode[visit])) continue;
      const drawn = vec3At(buffers.controls, 4 * plan.controlOfVisit[visit]);
      expect(drawn).toEqual(vec3At(frame.q, 3 * fabric.visitNode[visit]));
    }
  });

  it('keep loops and their legs apart', () => {
    for (const { q } of frames) {
      traceCurves(fabric, plan, q, new Float64Array(fabric.numVisits).fill(NaN), again);
      const nearest = nearestTurns(again.points);
      expect(Math.min(...nearest)).toBeGreaterThan(0.2);
      expect(nearest.filter((distance) => distance < 0.5).length / nearest.length).toBeLessThan(0.12);
    }
  });

  it('move little where nodes move little', () => {
    const [before, after] = [frames[0].q, frames[1].q];
    const steps = 200;
    let [last, most, fastest] = [new Float32Array(), 0, 0];
    for (let step = 0; step <= steps; ++step) {
      const q = before.map((value, i) => value + (step / steps) * (after[i] - value));
      traceCurves(fabric, plan, q, new Float64Array(fabric.numVisits).fill(NaN), again);
      again.points.forEach((value, i) => {
        if (i % 4 < 3 && last.length > 0) most = Math.max(most, Math.abs(value - last[i]));
      });
      last = again.points.slice();
    }
    for (let i = 0; i < 3 * fabric.numNodes; ++i) fastest = Math.max(fastest, Math.abs(after[i] - before[i]) / steps);
    expect(most).toBeLessThan(3 * fastest);
  });

  it('keep the two yarns of a contact a diameter apart', () => {
    for (const { uVisit, vVisit } of fabric.contacts) {
      for (const end of [0, 1] as const) {
        const at = (visit: number): [number, number, number] => vec3At(buffers.controls, 4 * plan.controlOfVisit[visit]);
        expect(norm(sub(at(uVisit[end]), at(vVisit[end])))).toBeCloseTo(2 * fabric.radius, 9);
      }
    }
  });

  it('bring the new loop of a knit stitch to the front and of a purl stitch to the back', () => {
    // The right side looks along course x wale = x × -z = y.
    for (const stitch of fabric.stitches) {
      for (const base of stitch.bases) {
        const contact = fabric.contacts[base];
        const upper = contact.side === 'left' ? stitch.nodes[1] : stitch.nodes[6];
        const { atQ0, atQ1 } = separateContact(frames[0].q, contact, 1);
        const towardsRightSide = (upper === contact.q1 ? atQ1 : atQ0)[1];
        expect(towardsRightSide * (stitch.kind === 'KNIT' ? 1 : -1)).toBeGreaterThan(0.9);
      }
    }
  });

  it('mark where nothing is drawn, and where a value is missing', () => {
    const lengths = pointLengths(plan, buffers.points);
    expect(lengths[0]).toBe(-1);
    expect(lengths[plan.numPoints - 1]).toBe(-1);
    expect(lengths[1]).toBe(0);
    expect(buffers.points[4 * 10 + 3]).toBeCloseTo(noValue, -24);
  });

  it('end in round caps', () => {
    const thickness = pointThickness(plan);
    const caps = capPoints.map((cap) => Math.fround(cap.thickness));
    expect([...thickness.slice(1, 1 + caps.length)]).toEqual([...caps].reverse());
    expect([...thickness.slice(-1 - caps.length, -1)]).toEqual(caps);
    const [end, tip] = [1 + caps.length, 1].map((point) => vec3At(buffers.points, 4 * point));
    expect(norm(sub(end, tip))).toBeCloseTo(fabric.radius, 9);
  });

  it('give a value between two visits linearly', () => {
    const values = Float64Array.from({ length: fabric.numVisits }, (_, visit) => visit);
    const coloured = makeCurveBuffers(plan);
    traceCurves(fabric, plan, frame.q, values, coloured);
    for (let point = 1 + capPoints.length; point + 1 + capPoints.length < plan.numPoints - 4; ++point) {
      expect(coloured.points[4 * point + 7]).toBeGreaterThan(coloured.points[4 * point + 3]);
    }
  });
});

describe('picking', () => {
  it('finds the nearest yarn along the ray, and its stitch', () => {
    const lengths = pointLengths(plan, buffers.points);
    const stitch = fabric.stitches.findIndex(({ course, wale }) => course === 2 && wale === 2);
    const visit = fabric.stitchOfVisit.indexOf(stitch);
    const target = vec3At(buffers.controls, 4 * plan.controlOfVisit[visit]);
    const point = pickPoint(buffers.points, lengths, { origin: [target[0], target[1] + 0.1, target[2]], direction: [0, -1, 0] }, fabric.radius, 0);
    const hit = vec3At(buffers.points, 4 * point);
    expect(Math.hypot(hit[0] - target[0], hit[2] - target[2])).toBeLessThan(1.5 * fabric.radius);
    expect(hit[1]).toBeGreaterThan(target[1] - fabric.radius);
    expect(fabric.stitchOfVisit[visitOfPoint(plan, point)]).toBeGreaterThanOrEqual(0);
  });
  it('finds nothing beside the fabric', () => {
    const lengths = pointLengths(plan, buffers.points);
    expect(pickPoint(buffers.points, lengths, { origin: [1, 1, 1], direction: [0, 0, 1] }, fabric.radius, 0.001)).toBe(-1);
  });
});

describe('stitches', () => {
  it('own their visits: eight a loop but for the edges', () => {
    const inner = fabric.stitches.findIndex(({ course, wale }) => course === 2 && wale === 2);
    expect([...fabric.stitchOfVisit].filter((owner) => owner === inner)).toHaveLength(8);
    const outer = fabric.stitches.findIndex(({ course, wale }) => course === 1 && wale === 2);  // its base has one yarn
    expect([...fabric.stitchOfVisit].filter((owner) => owner === outer)).toHaveLength(8);
    expect(new Set(fabric.stitchOfVisit).size).toBe(9 + 1);
  });
});
