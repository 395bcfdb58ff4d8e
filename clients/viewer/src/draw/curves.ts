// SPDX-License-Identifier: MIT
// The drawn curves of one frame, written into one array: four numbers a point, x y z in m and the value to colour by.
import type { Fabric } from '../fabric/fabric';
import { makeSpreadBuffers, numLevels, spread, type SpreadBuffers } from '../fabric/spread';
import { cross, direction, scaled, sub, type Vec3, vec3At } from '../fabric/vec3';
import { capPoints, type CurvePlan } from './curve_plan';

/// Stands for "no value": shaders may not tell NaN from numbers.
export const noValue = -1e30;

const stride = 4;

/// Room for the control points, kept from frame to frame.
export interface CurveBuffers {
  controls: Float64Array;  // 4 each
  points: Float32Array;    // 4 each
  spread: SpreadBuffers;
}

export function makeCurveBuffers(plan: CurvePlan): CurveBuffers {
  return {
    controls: new Float64Array(stride * plan.numControls),
    points: new Float32Array(stride * Math.max(plan.numPoints, 1)),
    spread: makeSpreadBuffers(plan.spread),
  };
}

function placeVisits(fabric: Fabric, plan: CurvePlan, q: ArrayLike<number>, values: ArrayLike<number>, controls: Float64Array): void {
  for (let control = 0; control < plan.numControls; ++control) {
    const visit = plan.visit[control];
    const part = plan.along[control] / (numLevels - 1);
    const [a, b] = part > 0 ? [visit, visit + 1] : [visit, visit];
    const [na, nb] = [3 * fabric.visitNode[a], 3 * fabric.visitNode[b]];
    for (let c = 0; c < 3; ++c) controls[stride * control + c] = (1 - part) * q[na + c] + part * q[nb + c];
    const value = (1 - part) * values[a] + part * values[b];
    controls[stride * control + 3] = Number.isNaN(value) ? noValue : value;
  }
}

function move(controls: Float64Array, control: number, by: Vec3, factor: number): void {
  for (let c = 0; c < 3; ++c) controls[stride * control + c] += factor * by[c];
}

/// To where `spread` has moved a yarn's point at one level of a post.
function place(controls: Float64Array, control: number, { centre, offset }: SpreadBuffers, at: number, side: number): void {
  for (let c = 0; c < 3; ++c) controls[stride * control + c] = centre[at + c] + side * offset[at + c];
}

function separate(fabric: Fabric, plan: CurvePlan, q: ArrayLike<number>, controls: Float64Array, buffers: SpreadBuffers): void {
  spread(fabric, plan.spread, q, buffers);
  plan.spread.posts.forEach(({ visits }, post) => {
    const at = 3 * numLevels * post;
    for (const { low, high, side } of visits) {
      const [from, to] = [plan.controlOfVisit[low], plan.controlOfVisit[high]];
      const step = Math.abs(from - to) === numLevels - 1 ? 1 : numLevels - 1;
      for (let level = 0; level < numLevels; level += step) {
        place(controls, from + Math.sign(to - from) * (step === 1 ? level : Math.abs(to - from) * level / step), buffers, at + 3 * level, side);
      }
    }
  });
  for (const [one, other] of plan.crossings) {
    const tangent = (visit: number): Vec3 => {
      const last = fabric.numVisits - 1;
      const [a, b] = [fabric.visitNode[Math.max(visit - 1, 0)], fabric.visitNode[Math.min(visit + 1, last)]];
      return sub(vec3At(q, 3 * b), vec3At(q, 3 * a));
    };
    const apart = scaled(direction(cross(tangent(one), tangent(other)), [0, 0, 1]), fabric.radius);
    move(controls, plan.controlOfVisit[one], apart, 1);
    move(controls, plan.controlOfVisit[other], apart, -1);
  }
}

/// Cubic Hermite between control points b and c, with slopes that take their distances into account, so that long spans
/// beside short ones do not overshoot.
function smoothSpan(controls: Float64Array, a: number, b: number, c: number, d: number, cuts: number, points: Float32Array, at: number): void {
  const distance = (i: number, j: number): number => Math.max(1e-12, Math.hypot(
    controls[stride * j] - controls[stride * i], controls[stride * j + 1] - controls[stride * i + 1],
    controls[stride * j + 2] - controls[stride * i + 2]));
  const [before, here, behind] = [a === b ? 1 : distance(a, b), distance(b, c), c === d ? 1 : distance(c, d)];
  for (let k = 0; k < cuts; ++k) {
    const s = k / cuts;
    const [s2, s3] = [s * s, s * s * s];
    const to = at + stride * k;
    for (let i = 0; i < 3; ++i) {
      const [pb, pc] = [controls[stride * b + i], controls[stride * c + i]];
      const chord = (pc - pb) / here;
      const left = a === b ? chord : (pb - controls[stride * a + i]) / before;
      const right = c === d ? chord : (controls[stride * d + i] - pc) / behind;
      const slopeB = ((left * here + chord * before) / (before + here)) * here;
      const slopeC = ((chord * behind + right * here) / (here + behind)) * here;
      points[to + i] = (2 * s3 - 3 * s2 + 1) * pb + (s3 - 2 * s2 + s) * slopeB + (3 * s2 - 2 * s3) * pc + (s3 - s2) * slopeC;
    }
    const [vb, vc] = [controls[stride * b + 3], controls[stride * c + 3]];
    points[to + 3] = vb === noValue ? vc : vc === noValue ? vb : vb + s * (vc - vb);
  }
}

function smoothYarn(plan: CurvePlan, yarn: number, radius: number, { controls, points }: CurveBuffers): void {
  const [first, end] = [plan.yarnFirst[yarn], plan.yarnFirst[yarn + 1]];
  if (end === first) return;
  const start = stride * (plan.pointFirst[yarn] + 1 + capPoints.length);
  let at = start;
  for (let b = first; b + 1 < end; ++b) {
    smoothSpan(controls, Math.max(b - 1, first), b, b + 1, Math.min(b + 2, end - 1), plan.cuts, points, at);
    at += stride * plan.cuts;
  }
  for (let c = 0; c < stride; ++c) points[at + c] = controls[stride * (end - 1) + c];
  addCap(points, start, -stride, radius);
  addCap(points, at, stride, radius);
}

/// Points beyond an end that go straight on: the cap, then a ghost. `step`: outwards.
function addCap(points: Float32Array, end: number, step: number, radius: number): void {
  const out = direction(sub(vec3At(points, end), vec3At(points, end - step)), [1, 0, 0]);
  [...capPoints.map(({ beyond }) => beyond), 1.2].forEach((beyond, index) => {
    const at = end + (index + 1) * step;
    for (let c = 0; c < 3; ++c) points[at + c] = points[end + c] + beyond * radius * out[c];
    points[at + 3] = points[end + 3];
  });
}

/// `values`: one a visit. The result is in buffers.points.
export function traceCurves(fabric: Fabric, plan: CurvePlan, q: ArrayLike<number>, values: ArrayLike<number>, buffers: CurveBuffers): void {
  placeVisits(fabric, plan, q, values, buffers.controls);
  separate(fabric, plan, q, buffers.controls, buffers.spread);
  for (let yarn = 0; yarn + 1 < plan.yarnFirst.length; ++yarn) smoothYarn(plan, yarn, fabric.radius, buffers);
}

/// Per point: its length along the yarn so far in m, or -1 where no segment to the next point is drawn.
export function pointLengths(plan: CurvePlan, points: Float32Array): Float32Array {
  const lengths = new Float32Array(plan.numPoints).fill(-1);
  for (let yarn = 0; yarn + 1 < plan.pointFirst.length; ++yarn) {
    let length = 0;
    for (let i = plan.pointFirst[yarn] + 1; i + 2 < plan.pointFirst[yarn + 1]; ++i) {
      lengths[i] = length;
      const [a, b] = [stride * i, stride * (i + 1)];
      length += Math.hypot(points[b] - points[a], points[b + 1] - points[a + 1], points[b + 2] - points[a + 2]);
    }
  }
  return lengths;
}

/// Per point: how thick the tube is there, as a part of its radius.
export function pointThickness(plan: CurvePlan): Float32Array {
  const thickness = new Float32Array(plan.numPoints).fill(1);
  for (let yarn = 0; yarn + 1 < plan.pointFirst.length; ++yarn) {
    capPoints.forEach((cap, index) => {
      thickness[plan.pointFirst[yarn] + capPoints.length - index] = cap.thickness;
      thickness[plan.pointFirst[yarn + 1] - 1 - capPoints.length + index] = cap.thickness;
    });
  }
  return thickness;
}

/// The visit that a drawn point belongs to.
export function visitOfPoint(plan: CurvePlan, point: number): number {
  let yarn = 0;
  while (yarn + 2 < plan.pointFirst.length && point >= plan.pointFirst[yarn + 1]) ++yarn;
  const span = Math.round((point - plan.pointFirst[yarn] - 1 - capPoints.length) / plan.cuts);
  const control = Math.min(Math.max(plan.yarnFirst[yarn] + span, plan.yarnFirst[yarn]), plan.yarnFirst[yarn + 1] - 1);
  return plan.visit[control];
}
