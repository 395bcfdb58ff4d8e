// SPDX-License-Identifier: MIT
// Yarns that meet share their nodes; to be drawn they are moved apart by a radius each. In a stitch contact they wind
// half a turn around each other: each passes between the legs of the other.
import type { Contact, Fabric } from './fabric';
import { across, add, cross, direction, scaled, sub, type Vec3, vec3At } from './vec3';

/// Where yarn u is moved at node q0, in the middle and at node q1 of a contact; yarn v is moved the opposite way.
export interface Separation {
  atQ0: Vec3;
  middle: Vec3;
  atQ1: Vec3;
}

const nowhere: Vec3 = [0, 0, 0];

export function separateContact(q: ArrayLike<number>, contact: Contact, radius: number): Separation {
  const at = (node: number): Vec3 => vec3At(q, 3 * node);
  const arm = (from: number, to: number): Vec3 => (to < 0 ? nowhere : direction(sub(at(to), at(from)), nowhere));
  const { q0, q1, q2, q3, q4, q5 } = contact;
  const axis = direction(sub(at(q1), at(q0)), [1, 0, 0]);
  const legs = sub(add(arm(q0, q4), arm(q1, q5)), add(arm(q0, q2), arm(q1, q3)));
  const spare = cross(axis, Math.abs(axis[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0]);
  const toU = direction(across(legs, axis), direction(spare, [0, 0, 1]));  // the side from which yarn u comes
  const turn = scaled(cross(axis, toU), contact.sign * radius);
  return { atQ0: scaled(turn, -1), middle: scaled(toU, -radius), atQ1: turn };
}

/// Nodes that two yarns share outside stitch contacts: [visit of one, visit of the other].
export function findCrossings(fabric: Fabric): [number, number][] {
  const inContact = new Set(fabric.contacts.flatMap(({ q0, q1 }) => [q0, q1]));
  const firstVisit = new Map<number, number>();
  const crossings: [number, number][] = [];
  fabric.visitNode.forEach((node, visit) => {
    if (inContact.has(node)) return;
    const other = firstVisit.get(node);
    if (other === undefined) firstVisit.set(node, visit);
    else crossings.push([other, visit]);
  });
  return crossings;
}
