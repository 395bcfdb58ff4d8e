// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { orderText } from '../src/api/sim_jobs';
import { orderOf } from '../src/editor/order_fields';

describe('orders', () => {
  it('are members of a spec', () => {
    expect(JSON.parse(`{${orderText({ work: 'simulate', budget_s: 5 })}}`)).toEqual({ simulate: {} });
    expect(JSON.parse(`{${orderText({ work: 'study', threads: 3 })}}`)).toEqual({ study: {}, threads: 3 });
    expect(JSON.parse(`{${orderText({ work: 'quick study', budget_s: 0.5 })}}`)).toEqual({ study: { quick: true, budget_s: 0.5 } });
  });
  it('are those of a job that is copied', () => {
    expect(orderOf({ simulate: {}, threads: 2 })).toEqual({ work: 'simulate', threads: 2 });
    expect(orderOf({ study: { budget_s: 60 }, threads: 1 })).toEqual({ work: 'study', budget_s: 60, threads: 1 });
    expect(orderOf({ study: { quick: true, budget_s: 0 } })).toEqual({ work: 'quick study' });
  });
});
