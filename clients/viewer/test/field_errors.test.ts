// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { ApiError, errorFromBody } from '../src/api/api_error';
import { fieldErrors, pathAndAncestors, placeOf } from '../src/api/field_errors';
import { headline } from '../src/form/show_errors';

const refusal = JSON.stringify({
  code: 3, message: '2 problems',
  details: [
    { '@type': 'type.googleapis.com/google.rpc.ErrorInfo', reason: 'INVALID_SCENE', domain: 'slipstitch', metadata: { violations_left_out: '4' } },
    { '@type': 'type.googleapis.com/google.rpc.BadRequest', field_violations: [
      { field: 'spec.scene.yarn.radius_m', description: 'is -1, expected a finite number > 0' },
      { field: 'spec.threads', description: 'is 2000, expected 0 to 1024' },
      { field: 'request_id', description: 'is "é", expected letters' }] }],
});

describe('errors of the server', () => {
  const error = errorFromBody(400, refusal);
  it('keep reason and status', () => {
    expect(error).toBeInstanceOf(ApiError);
    expect([error.httpStatus, error.reason, error.message]).toEqual([400, 'INVALID_SCENE', '2 problems']);
  });
  it('become errors of fields, those beside the scene under their label, others with their path', () => {
    expect(fieldErrors(error)).toEqual([
      { path: 'yarn.radius_m', message: 'is -1, expected a finite number > 0' },
      { path: 'Threads', message: 'is 2000, expected 0 to 1024', about: 'order' },
      { path: '', message: 'request_id is "é", expected letters', about: 'server' },
      { path: '', message: 'and 4 more' },
    ]);
  });
  it('without violations are one of the whole', () => {
    expect(fieldErrors(errorFromBody(429, '{"code":8,"message":"the queue is full"}'))).toEqual([{ path: '', message: 'the queue is full', about: 'server' }]);
  });
  it('survive a body that is no status', () => expect(errorFromBody(502, '<html>').message).toBe('the server answered HTTP 502: <html>'));
});

describe('headlines', () => {
  it('blame the scene for what is in it only', () => {
    const [scene, order, server] = [{ path: 'yarn', message: '' }, { path: 'Work', message: '', about: 'order' as const }, { path: '', message: '', about: 'server' as const }];
    expect(headline([scene])).toBe('This scene has a problem');
    expect(headline([scene, scene])).toBe('This scene has 2 problems');
    expect(headline([order])).toBe('This job has a problem');
    expect(headline([scene, order])).toBe('This job has 2 problems');
    expect(headline([server])).toBe('This did not work');
  });
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
