// SPDX-License-Identifier: MIT
import { dot, norm, scaled, sub, type Vec3, vec3At } from '../fabric/vec3';

export interface Ray {
  origin: Vec3;
  direction: Vec3;  // unit length
}

/// The drawn point nearest to the eye whose tube the ray meets, with a little help for fingers; -1: none.
/// `points`: four numbers each; `lengths`: negative where no segment to the next point is drawn.
export function pickPoint(points: Float32Array, lengths: Float32Array, ray: Ray, radius: number, slack: number): number {
  let [best, bestDepth] = [-1, Infinity];
  for (let i = 0; i + 1 < lengths.length; ++i) {
    if (lengths[i] < 0) continue;
    const a = vec3At(points, 4 * i);
    const middle = scaled([a[0] + points[4 * i + 4], a[1] + points[4 * i + 5], a[2] + points[4 * i + 6]], 0.5);
    const toPoint = sub(middle, ray.origin);
    const depth = dot(toPoint, ray.direction);
    if (depth <= 0 || depth >= bestDepth) continue;
    const miss = norm(sub(toPoint, scaled(ray.direction, depth)));
    if (miss > radius + slack * depth) continue;
    [best, bestDepth] = [i, depth];
  }
  return best;
}
