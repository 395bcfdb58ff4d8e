// SPDX-License-Identifier: MIT
// Which points the drawn curves go through: one a visit, and a few more within every stitch contact. Made once a job.
import type { Fabric } from '../fabric/fabric';
import { findCrossings } from '../fabric/separate';
import { numLevels, planSpread, type SpreadPlan } from '../fabric/spread';

export interface CurvePlan {
  numControls: number;
  yarnFirst: Int32Array;      // first control point of each yarn, then their number
  visit: Int32Array;          // per control point: its visit, or the first of the two around a middle
  along: Uint8Array;          // how many levels of a contact it lies beyond that visit
  crossings: readonly [number, number][];
  spread: SpreadPlan;
  controlOfVisit: Int32Array;
  cuts: number;               // drawn segments between two control points
  numPoints: number;          // of the drawn curves; each yarn has a ghost and a round cap of points at both ends
  pointFirst: Int32Array;     // first drawn point of each yarn, a ghost; then their number
}

/// Points of a cap, beyond the end of the yarn: how far in radii, and how thick there, as parts of the radius.
export const capPoints: readonly { beyond: number; thickness: number }[] = [
  { beyond: 0.5, thickness: 0.866 }, { beyond: 0.866, thickness: 0.5 }, { beyond: 1, thickness: 0 },
];

const manyPoints = 70_000;  // from where on curves are drawn coarser
const mostCuts = 4;

/// Visits behind which a contact's middle lies.
function middleVisits(fabric: Fabric): Set<number> {
  const visits = new Set<number>();
  for (const { uVisit, vVisit } of fabric.contacts) {
    for (const [a, b] of [uVisit, vVisit]) if (a >= 0 && b >= 0 && Math.abs(a - b) === 1) visits.add(Math.min(a, b));
  }
  return visits;
}

export function planCurves(fabric: Fabric): CurvePlan {
  const middles = middleVisits(fabric);
  const visit: number[] = [];
  const along: number[] = [];
  const yarnFirst: number[] = [0];
  const controlOfVisit = new Int32Array(fabric.numVisits);
  for (let yarn = 0; yarn + 1 < fabric.yarnFirst.length; ++yarn) {
    for (let i = fabric.yarnFirst[yarn]; i < fabric.yarnFirst[yarn + 1]; ++i) {
      controlOfVisit[i] = visit.length;
      visit.push(i);
      along.push(0);
      if (!middles.has(i)) continue;
      for (let level = 1; level < numLevels - 1; ++level) {
        visit.push(i);
        along.push(level);
      }
    }
    yarnFirst.push(visit.length);
  }
  const cuts = Math.max(1, Math.min(mostCuts, Math.floor(manyPoints / Math.max(visit.length, 1))));
  const pointFirst = [0];
  for (let yarn = 0; yarn + 1 < yarnFirst.length; ++yarn) {
    pointFirst.push(pointFirst[yarn] + Math.max(yarnFirst[yarn + 1] - yarnFirst[yarn] - 1, 0) * cuts + 1 + 2 * (1 + capPoints.length));
  }
  return {
    numControls: visit.length,
    yarnFirst: Int32Array.from(yarnFirst),
    visit: Int32Array.from(visit),
    along: Uint8Array.from(along),
    crossings: findCrossings(fabric),
    spread: planSpread(fabric),
    controlOfVisit,
    cuts,
    numPoints: pointFirst[pointFirst.length - 1],
    pointFirst: Int32Array.from(pointFirst),
  };
}
