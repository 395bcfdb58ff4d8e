// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { orderText } from '../src/api/sim_jobs';
import { orderOf, parseBudget, parseThreads } from '../src/editor/order_fields';

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
  it('are within the bounds of the server', () => {
    expect(['', '0', '1024', ' 7 '].map(parseThreads)).toEqual([undefined, 0, 1024, 7]);
    expect(() => parseThreads('1025')).toThrow(/^is 1025, expected 0 to 1024$/);
    expect(() => parseThreads('-1')).toThrow(/^is -1, expected 0 to 1024$/);
    expect(() => parseThreads('1.5')).toThrow(/^is 1.5, expected a whole number$/);
    expect(() => parseThreads('99999999999999999999')).toThrow(/expected 0 to 1024$/);
    expect(['', '0', '0,5', '1e9'].map(parseBudget)).toEqual([undefined, 0, 0.5, 1e9]);
    expect(() => parseBudget('-0.1')).toThrow(/^is -0.1, expected a finite number >= 0$/);
    expect(() => parseBudget('an hour')).toThrow(/^is “an hour”, expected a number$/);
  });
});
