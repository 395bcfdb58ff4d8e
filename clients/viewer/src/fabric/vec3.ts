// SPDX-License-Identifier: MIT
export type Vec3 = [number, number, number];

export const vec3At = (values: ArrayLike<number>, at: number): Vec3 => [values[at], values[at + 1], values[at + 2]];
export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scaled = (a: Vec3, factor: number): Vec3 => [a[0] * factor, a[1] * factor, a[2] * factor];
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const norm = (a: Vec3): number => Math.sqrt(dot(a, a));
export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/// The direction of a, or `fallback` where a is (nearly) nothing.
export function direction(a: Vec3, fallback: Vec3): Vec3 {
  const length = norm(a);
  return length > 1e-12 ? scaled(a, 1 / length) : fallback;
}

/// The part of a that is perpendicular to the unit vector e.
export function across(a: Vec3, e: Vec3): Vec3 {
  return sub(a, scaled(e, dot(a, e)));
}
