// SPDX-License-Identifier: MIT
import { slidLengths, strains } from './derive';
import type { Fabric, Frame } from './fabric';
import { contactWraps } from './quantities';

export interface StitchFacts {
  course: number;
  wale: number;
  kind: string;
  meanStretch: number;   // of the segments of its loop, a part
  mostTension: number;   // N
  wraps: readonly { where: string; angle: number }[];  // rad, signed as quantities say
  slid: number;          // the largest, signed, m
  length: number;        // arc length of its loop in m
}

function signedMost(values: readonly number[]): number {
  return values.reduce((most, value) => (Math.abs(value) > Math.abs(most) ? value : most), 0);
}

export function stitchFacts(fabric: Fabric, frame: Frame, reference: Frame, index: number): StitchFacts {
  const stitch = fabric.stitches[index];
  const visits: number[] = [];
  fabric.stitchOfVisit.forEach((owner, visit) => owner === index && visits.push(visit));
  const strain = strains(fabric, frame);
  const ofLoop = visits.filter((visit) => fabric.hasSegment[visit] && visits.includes(visit + 1)).map((visit) => strain[visit]);
  const slid = slidLengths(fabric, frame, reference);
  const wraps = contactWraps(fabric, frame);
  const named = (contacts: readonly number[], where: string): { where: string; angle: number }[] =>
    contacts.map((contact) => ({ where: `${where} ${fabric.contacts[contact].side}`, angle: wraps[contact] }));
  const arcs = 3 * fabric.numNodes;
  const [first, last] = [Math.min(...visits), Math.max(...visits)];
  return {
    course: stitch.course,
    wale: stitch.wale,
    kind: stitch.kind === 'PURL' ? 'purl' : 'knit',
    meanStretch: ofLoop.reduce((sum, value) => sum + value, 0) / Math.max(ofLoop.length, 1),
    mostTension: fabric.stretch * ofLoop.reduce((most, value) => Math.max(most, value), -Infinity),
    wraps: [...named(stitch.bases, 'base'), ...named(stitch.heads, 'head')],
    slid: signedMost(visits.map((visit) => slid[visit])),
    length: visits.length > 0 ? frame.q[arcs + last] - frame.q[arcs + first] : 0,
  };
}
