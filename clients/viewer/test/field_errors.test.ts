// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { ApiError, errorFromBody } from '../src/api/api_error';
import { fieldErrors, pathAndAncestors, placeOf } from '../src/api/field_errors';

const refusal = JSON.stringify({
  code: 3, message: '2 problems',
  details: [
    { '@type': 'type.googleapis.com/google.rpc.ErrorInfo', reason: 'INVALID_SCENE', domain: 'slipstitch', metadata: { violations_left_out: '4' } },
    { '@type': 'type.googleapis.com/google.rpc.BadRequest', field_violations: [
      { field: 'spec.scene.yarn.radius_m', description: 'is -1, expected a finite number > 0' },
      { field: 'spec.threads', description: 'is 900, expected at most 256' }] }],
});

describe('errors of the server', () => {
  const error = errorFromBody(400, refusal);
  it('keep reason and status', () => {
    expect(error).toBeInstanceOf(ApiError);
    expect([error.httpStatus, error.reason, error.message]).toEqual([400, 'INVALID_SCENE', '2 problems']);
  });
  it('become errors of fields, those outside the scene with their path', () => {
    expect(fieldErrors(error)).toEqual([
      { path: 'yarn.radius_m', message: 'is -1, expected a finite number > 0' },
      { path: '', message: 'spec.threads is 900, expected at most 256' },
      { path: '', message: 'and 4 more' },
    ]);
  });
  it('without violations are one of the whole', () => {
    expect(fieldErrors(errorFromBody(429, '{"code":8,"message":"the queue is full"}'))).toEqual([{ path: '', message: 'the queue is full' }]);
  });
  it('survive a body that is no status', () => expect(errorFromBody(502, '<html>').message).toBe('the server answered HTTP 502: <html>'));
});

describe('places', () => {
  it('are looked for from the inside out', () => {
    expect(pathAndAncestors('a.b[2].c')).toEqual(['a.b[2].c', 'a.b[2]', 'a.b', 'a', '']);
    const shown = new Set(['a', 'a.b[2]']);
    expect(placeOf('a.b[2].c', (path) => shown.has(path))).toBe('a.b[2]');
    expect(placeOf('a.x', (path) => shown.has(path))).toBe('a');
    expect(placeOf('z', (path) => shown.has(path))).toBe('');
  });
});
