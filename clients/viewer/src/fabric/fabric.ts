// SPDX-License-Identifier: MIT
// What all frames of a job have in common, with every default filled in and flat arrays for the loops over it.
import type { FrameHeaderMessage, LengthKeyframe, StitchContactMessage, StitchKind, TopologyMessage } from '../api/messages';

export interface Contact {
  q0: number; q1: number; q2: number; q3: number; q4: number; q5: number;
  uVisit: readonly [number, number];
  vVisit: readonly [number, number];
  sign: number;
  kind: StitchKind;
  side: 'left' | 'right';
  stitch: number;
}

export interface Stitch {
  course: number;
  wale: number;
  kind: StitchKind;
  bases: readonly number[];  // contacts
  heads: readonly number[];
  nodes: readonly number[];
}

export interface Fabric {
  numNodes: number;
  numBodies: number;
  numVisits: number;
  yarnFirst: Int32Array;     // first visit of each yarn, then the number of visits
  visitNode: Int32Array;
  hasSegment: Uint8Array;    // per visit: whether a segment follows
  contacts: readonly Contact[];
  stitches: readonly Stitch[];
  stitchOfVisit: Int32Array; // -1: none
  numCourses: number;
  numWales: number;
  radius: number;            // m
  stretch: number;           // EA in N
  shrinkage: readonly LengthKeyframe[];
  framesPerSecond: number;
  numFrames: number;         // planned
}

/// A frame's numbers: positions of all nodes, then arc lengths of all visits, in m.
export interface Frame {
  index: number;
  t: number;
  q: Float64Array;
}

function pair(values: number[] | undefined): [number, number] {
  return [values?.[0] ?? -1, values?.[1] ?? -1];
}

function contactOf(message: StitchContactMessage): Contact {
  const { q0 = 0, q1 = 0, q2 = 0, q3 = 0, q4 = 0, q5 = 0 } = message;
  return {
    q0, q1, q2, q3, q4, q5,
    uVisit: pair(message.u_visit),
    vVisit: pair(message.v_visit),
    sign: message.sign ?? 0,
    kind: message.kind ?? 'KNIT',
    side: message.side === 'RIGHT_CLASP' ? 'right' : 'left',
    stitch: message.stitch ?? 0,
  };
}

function stitchesOf(topology: TopologyMessage): Stitch[] {
  const present = (contact: number): boolean => contact >= 0;
  return (topology.stitches ?? []).map((stitch) => ({
    course: stitch.course ?? 0,
    wale: stitch.wale ?? 0,
    kind: stitch.kind ?? 'KNIT',
    bases: [stitch.base_left ?? 0, stitch.base_right ?? 0].filter(present),
    heads: [stitch.head_left ?? 0, stitch.head_right ?? 0].filter(present),
    nodes: stitch.node ?? [],
  }));
}

/// A contact lies in two loops: in the new one by its yarn u, in the old one by its yarn v. Nodes outside contacts have
/// one visit.
function findStitches(visitNode: Int32Array, contacts: readonly Contact[], stitches: readonly Stitch[]): Int32Array {
  const stitchOfVisit = new Int32Array(visitNode.length).fill(-1);
  stitches.forEach((stitch, index) => {
    for (const base of stitch.bases) for (const visit of contacts[base].uVisit) if (visit >= 0) stitchOfVisit[visit] = index;
    for (const head of stitch.heads) for (const visit of contacts[head].vVisit) if (visit >= 0) stitchOfVisit[visit] = index;
  });
  const inContact = new Set(contacts.flatMap((contact) => [contact.q0, contact.q1]));
  const stitchOfNode = new Map<number, number>();
  stitches.forEach((stitch, index) => {
    for (const node of stitch.nodes) if (!inContact.has(node)) stitchOfNode.set(node, index);
  });
  visitNode.forEach((node, visit) => {
    if (stitchOfVisit[visit] < 0) stitchOfVisit[visit] = stitchOfNode.get(node) ?? -1;
  });
  return stitchOfVisit;
}

/// Throws an Error when the numbers do not fit together.
export function makeFabric(header: FrameHeaderMessage): Fabric {
  const topology = header.topology ?? {};
  const visitNode = Int32Array.from(topology.visit_node ?? []);
  const numNodes = topology.num_nodes ?? 0;
  const kinds = topology.segment_kind ?? [];
  if (kinds.length !== visitNode.length) throw new Error(`the header has ${kinds.length} segments for ${visitNode.length} visits`);
  if (visitNode.some((node) => node < 0 || node >= numNodes)) throw new Error('the header names a node that does not exist');
  const contacts = (topology.contacts ?? []).map(contactOf);
  const stitches = stitchesOf(topology);
  return {
    numNodes,
    numBodies: topology.num_bodies ?? 0,
    numVisits: visitNode.length,
    yarnFirst: Int32Array.from(topology.yarn_first ?? [0]),
    visitNode,
    hasSegment: Uint8Array.from(kinds, (kind) => (kind === 'FREE' || kind === 'CONTACT' ? 1 : 0)),
    contacts,
    stitches,
    stitchOfVisit: findStitches(visitNode, contacts, stitches),
    numCourses: topology.num_courses ?? 0,
    numWales: topology.num_wales ?? 0,
    radius: header.yarn?.radius_m ?? 0,
    stretch: header.yarn?.stretch_n ?? 0,
    shrinkage: header.shrinkage ?? [],
    framesPerSecond: header.frames_per_s ?? 0,
    numFrames: header.num_frames ?? 0,
  };
}

export function stateLength(fabric: Fabric): number {
  return 3 * fabric.numNodes + fabric.numVisits;
}
