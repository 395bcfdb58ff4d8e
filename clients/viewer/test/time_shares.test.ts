// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { timeShares } from '../src/jobs/time_shares';

const shares = (byPhase: Record<string, number>, wall: number): [string, number][] =>
  timeShares(byPhase, wall).map(({ name, share }) => [name, Number(share.toFixed(3))]);

describe('timeShares', () => {
  it('are of the wall time, in one order, with the rest at the end', () => {
    expect(shares({ solve: 1, assembly: 2, factor: 5 }, 10)).toEqual([['forces and stiffness', 0.2], ['factorisation', 0.5], ['linear solves', 0.1], ['the rest', 0.2]]);
    expect(shares({ factor: 5, solve: 1, assembly: 2 }, 10).map(([name]) => name)).toEqual(['forces and stiffness', 'factorisation', 'linear solves', 'the rest']);
  });
  it('name a choice of effects, before what every step does', () => {
    expect(shares({ begin_step: 2, choosing_effects: 8 }, 10)).toEqual([['choosing effects', 0.8], ['step set-up', 0.2]]);
    expect(timeShares({ choosing_effects: 1 })[0].light).not.toBe(timeShares({ some_thing: 1 })[0].light);
  });
  it('keep what is newer than this viewer, and leave what is too little to the rest', () => {
    expect(shares({ some_thing: 5, solve: 4.96, energy: 0.04 }, 10)).toEqual([['linear solves', 0.496], ['some thing', 0.5]]);
  });
  it('are none where nothing is known', () => {
    expect(timeShares({}, 10)).toEqual([]);
    expect(timeShares(undefined, undefined)).toEqual([]);
    expect(timeShares(null, 10)).toEqual([]);
    expect(timeShares({ factor: 0 }, 0)).toEqual([]);
  });
  it('add up to all of it, though the wall time told is too short', () => {
    expect(shares({ assembly: 6, factor: 6 }, 10)).toEqual([['forces and stiffness', 0.5], ['factorisation', 0.5]]);
  });
});
