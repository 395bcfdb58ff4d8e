// SPDX-License-Identifier: MIT
import type { Fabric } from './fabric';

/// One end of a leg: a contact, where another yarn winds around it, or the like at an edge, where it is alone.
export interface Post {
  low: number;   // nodes
  high: number;
  stitch: number;
  contact: number;  // -1: none
  visits: readonly { low: number; high: number; side: number }[];  // of each yarn; 1: yarn u of the contact, -1: v, 0: alone
}

function visitsOf(fabric: Fabric, visitOfNode: Map<number, number>, contact: number, low: number, high: number): Post['visits'] {
  const ends = (): { low: number; high: number; side: number }[] => {
    if (contact < 0) return [{ low: visitOfNode.get(low) ?? -1, high: visitOfNode.get(high) ?? -1, side: 0 }];
    const { q0, uVisit, vVisit } = fabric.contacts[contact];
    return [{ visits: uVisit, side: 1 }, { visits: vVisit, side: -1 }].map(({ visits: [a, b], side }) => (
      q0 === low ? { low: a, high: b, side } : { low: b, high: a, side }));
  };
  return ends().filter((visit) => visit.low >= 0 && visit.high >= 0);
}

/// The posts between one course and the next, from left to right: one list for each course, and one below the first.
export function planPosts(fabric: Fabric): Post[][] {
  const visitOfNode = new Map(Array.from(fabric.visitNode, (node, visit) => [node, visit]));
  const contactOfNode = new Map(fabric.contacts.flatMap(({ q0, q1 }, contact) => [[q0, contact], [q1, contact]] as const));
  const rows = new Map<number, Post[]>();
  const known = new Set<number>();
  const add = (course: number, stitch: number, low: number | undefined, high: number | undefined): void => {
    if (low === undefined || high === undefined || low < 0 || high < 0 || known.has(low)) return;
    known.add(low);
    const contact = contactOfNode.get(low) ?? -1;
    const row = rows.get(course) ?? [];
    rows.set(course, row);
    row.push({ low, high, stitch, contact, visits: visitsOf(fabric, visitOfNode, contact, low, high) });
  };
  const order = fabric.stitches.map((_, stitch) => stitch).sort((a, b) => fabric.stitches[a].wale - fabric.stitches[b].wale);
  for (const stitch of order) {
    const { course, nodes } = fabric.stitches[stitch];
    add(course - 1, stitch, nodes[0], nodes[1]);
    add(course - 1, stitch, nodes[7], nodes[6]);
    add(course, stitch, nodes[2], nodes[3]);
    add(course, stitch, nodes[5], nodes[4]);
  }
  return [...rows.values()];
}
