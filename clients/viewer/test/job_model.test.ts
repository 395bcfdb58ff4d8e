// SPDX-License-Identifier: MIT
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { SimJob } from '../src/api/messages';
import { JobModel } from '../src/jobs/job_model';
import { progressText } from '../src/jobs/job_text';
import { streamBytes } from './golden';

/// What the server has: tests change it while the page asks.
interface Server {
  job: SimJob;
  historyRows: number;
  historyAnswers(): number;  // HTTP status
  streams: boolean;          // frames of the golden run, all at once
  asked: string[];
}

function historyText(rows: number): string {
  return ['t_s,kinetic_j', ...Array.from({ length: rows }, (_, row) => `${row / 10},1`), ''].join('\n');
}

/// The golden frames without their end, held open as of a job that runs.
function runningStream(signal: AbortSignal | null | undefined): Response {
  const bytes = streamBytes();
  return new Response(new ReadableStream({
    start: (stream) => {
      stream.enqueue(bytes.slice(0, endRecordAt(bytes)));
      signal?.addEventListener('abort', () => stream.error(new DOMException('let go', 'AbortError')));
    },
  }));
}

function endRecordAt(bytes: Uint8Array): number {
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  let at = 0;
  while (view.getUint32(at, true) !== 3) at += 24 + 8 * Math.ceil(Number(view.getBigUint64(at + 8, true)) / 8);
  return at;
}

function serve(server: Server): void {
  vi.stubGlobal('navigator', {});
  vi.stubGlobal('document', { visibilityState: 'visible', addEventListener: () => undefined });
  vi.stubGlobal('fetch', async (path: string, init?: RequestInit) => {
    server.asked.push(path);
    if (path.includes('frames:stream')) return server.streams ? runningStream(init?.signal) : new Response('{}', { status: 503 });
    if (path.endsWith('history.csv')) return new Response(historyText(server.historyRows), { status: server.historyAnswers() });
    if (path.endsWith('scene.json')) return new Response('{"scene":{}}');
    return new Response(JSON.stringify(server.job));
  });
}

const running: SimJob = { state: 'RUNNING', revision: '1', progress: { t: 0.1, duration_s: 100, frames: 2, num_frames: 1001 } };

function freshServer(): Server {
  return { job: running, historyRows: 2, historyAnswers: () => 200, streams: false, asked: [] };
}

describe('JobModel', () => {
  let model: JobModel;
  beforeEach(() => {
    vi.useFakeTimers();
    model = new JobModel('a');
  });
  afterEach(() => {
    model.end();
    vi.useRealTimers();
    vi.unstubAllGlobals();
  });
  const histories = (server: Server): number => server.asked.filter((path) => path.endsWith('history.csv')).length;

  it.each([
    ['breaks', 503], ['is refused for a while', 429],
  ])('has the whole history of a job that ended, though asking for it %s', async (_, status) => {
    const server = freshServer();
    serve(server);
    model.start();
    await vi.advanceTimersByTimeAsync(1500);
    expect(model.history.value?.rows).toBe(2);
    const failures = { left: 3 };
    Object.assign(server, { historyRows: 7, historyAnswers: () => (failures.left-- > 0 ? status : 200), job: { ...running, state: 'SUCCEEDED', revision: '2' } });
    await vi.advanceTimersByTimeAsync(60_000);
    expect(model.history.value?.rows).toBe(7);
    const asked = histories(server);
    await vi.advanceTimersByTimeAsync(60_000);
    expect(histories(server)).toBe(asked);
  });

  it('has it too when the answer to Cancel tells of the end first', async () => {
    const server = freshServer();
    serve(server);
    model.start();
    await vi.advanceTimersByTimeAsync(1500);
    Object.assign(server, { historyRows: 7, job: { ...running, state: 'CANCELLED', revision: '2' } });
    model.learn(server.job);
    await vi.advanceTimersByTimeAsync(60_000);
    expect(model.history.value?.rows).toBe(7);
  });

  it('asks no more for the history of a job that never began', async () => {
    const server = freshServer();
    Object.assign(server, { job: { state: 'CANCELLED', revision: '1' }, historyAnswers: () => 404 });
    serve(server);
    model.start();
    await vi.advanceTimersByTimeAsync(60_000);
    expect(histories(server)).toBe(1);
  });

  it('counts the frames that came, where the job tells of fewer', async () => {
    const server = freshServer();
    Object.assign(server, { streams: true, historyRows: 3 });
    serve(server);
    model.start();
    await vi.advanceTimersByTimeAsync(1500);
    expect(model.store.last?.index).toBe(2);
    const last = model.store.last?.t ?? 0;
    const t = Math.max(0.1, last);
    expect(model.progress()).toEqual({ ...running.progress, frames: 3, t, share_done: t / 100 });
    expect(progressText(running, model.progress())).toContain('frame 2 of 1000');
    server.job = { ...running, revision: '2', progress: { ...running.progress, t: 50, frames: 501 } };
    await vi.advanceTimersByTimeAsync(1500);
    expect(progressText(server.job, model.progress())).toMatch(/^50 of 100 s · frame 500 of 1000 · /);
  });

  it('asks for the history as frames come, though the job tells of none', async () => {
    const server = freshServer();
    Object.assign(server, { job: { ...running, progress: undefined }, historyRows: 0 });
    serve(server);
    model.start();
    await vi.advanceTimersByTimeAsync(1500);
    Object.assign(server, { streams: true, historyRows: 3 });
    await vi.advanceTimersByTimeAsync(10_000);
    expect(model.store.count).toBe(3);
    expect(model.history.value?.rows).toBe(3);
  });
});

describe('progressText', () => {
  it('counts frames as the player does', () => {
    expect(progressText(running)).toBe('0.1 of 100 s · frame 1 of 1000 · time left not known yet');
    expect(progressText({ ...running, progress: { duration_s: 1, num_frames: 31 } })).toContain('no frame yet');
    const early: SimJob = { state: 'CANCELLED', progress: { duration_s: 1, num_frames: 31, wall_s: 12 } };
    expect(progressText(early)).toBe('0 of 1 s · no frames · took 12 s');
    const choosing = { ...running, progress: { duration_s: 1, num_frames: 31, doing: 'choosing the effects: the first 0.1 s without sliding' } };
    expect(progressText(choosing)).toBe('choosing the effects: the first 0.1 s without sliding · time left not known yet');
    expect(progressText({ ...running, progress: { duration_s: 1, num_frames: 31, doing: 'simulating' } })).toContain('no frame yet');
  });
});
