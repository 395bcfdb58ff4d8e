// SPDX-License-Identifier: MIT
// What can be told from one frame; the same numbers as in exported frames.
import type { LengthKeyframe } from '../api/messages';
import type { Fabric, Frame } from './fabric';
import { cross, dot, sub, type Vec3, vec3At } from './vec3';

/// Rest length over arc length at time t: 1 at the start, linear in between, held after the last keyframe.
export function lengthFactor(keyframes: readonly LengthKeyframe[], t: number): number {
  let [t0, f0] = [0, 1];
  for (const keyframe of keyframes) {
    const [t1, f1] = [keyframe.t ?? 0, keyframe.factor ?? 1];
    if (t < t1) return f0 + ((f1 - f0) * (t - t0)) / (t1 - t0);
    [t0, f0] = [t1, f1];
  }
  return f0;
}

/// Signed angle between the triangles (x0, x1, x4) and (x0, x3, x1) about x1 - x0, in (-pi, pi].
export function wrapAngle(x0: Vec3, x1: Vec3, x3: Vec3, x4: Vec3): number {
  const axis = sub(x1, x0);
  const back = sub(x0, x1);
  const a = cross(sub(x4, x1), back);
  const b = cross(back, sub(x3, x1));
  const length = Math.sqrt(dot(axis, axis));
  if (length === 0) return 0;
  return Math.atan2(dot(axis, cross(a, b)) / length, dot(a, b));
}

/// Strain of every segment, by its first visit; NaN where there is none.
export function strains(fabric: Fabric, frame: Frame): Float64Array {
  const { q } = frame;
  const factor = lengthFactor(fabric.shrinkage, frame.t);
  const arcs = 3 * fabric.numNodes;
  const strain = new Float64Array(fabric.numVisits).fill(NaN);
  for (let visit = 0; visit < fabric.numVisits; ++visit) {
    if (!fabric.hasSegment[visit]) continue;
    const [a, b] = [3 * fabric.visitNode[visit], 3 * fabric.visitNode[visit + 1]];
    const length = Math.hypot(q[b] - q[a], q[b + 1] - q[a + 1], q[b + 2] - q[a + 2]);
    const rest = factor * (q[arcs + visit + 1] - q[arcs + visit]);
    strain[visit] = (length - rest) / rest;
  }
  return strain;
}

/// Mean over the segments before and behind every visit; 0 at a point without any.
export function visitMeans(fabric: Fabric, ofSegments: Float64Array): Float64Array {
  const means = new Float64Array(fabric.numVisits);
  for (let visit = 0; visit < fabric.numVisits; ++visit) {
    const before = visit > 0 && fabric.hasSegment[visit - 1] === 1;
    const behind = fabric.hasSegment[visit] === 1;
    if (before) means[visit] += ofSegments[visit - 1];
    if (behind) means[visit] += ofSegments[visit];
    if (before && behind) means[visit] /= 2;
  }
  return means;
}

/// Of every contact the angles of its diagonals (q4, q3) and (q5, q2), in rad; NaN where there is none.
export function wrapAngles(fabric: Fabric, frame: Frame): Float64Array {
  const angles = new Float64Array(2 * fabric.contacts.length).fill(NaN);
  const at = (node: number): Vec3 => vec3At(frame.q, 3 * node);
  fabric.contacts.forEach(({ q0, q1, q2, q3, q4, q5 }, index) => {
    if (q3 >= 0 && q4 >= 0) angles[2 * index] = wrapAngle(at(q0), at(q1), at(q3), at(q4));
    if (q2 >= 0 && q5 >= 0) angles[2 * index + 1] = wrapAngle(at(q1), at(q0), at(q2), at(q5));
  });
  return angles;
}

/// Arc length now minus at the reference frame, of every visit, in m.
export function slidLengths(fabric: Fabric, frame: Frame, reference: Frame): Float64Array {
  const arcs = 3 * fabric.numNodes;
  return Float64Array.from({ length: fabric.numVisits }, (_, visit) => frame.q[arcs + visit] - reference.q[arcs + visit]);
}
