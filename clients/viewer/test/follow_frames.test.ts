// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { ApiError } from '../src/api/api_error';
import { followFrames, type FrameSink } from '../src/api/follow_frames';
import type { StreamRange } from '../src/api/sim_jobs';
import { streamBytes } from './golden';

/// Bytes of the records of the golden stream from a frame on, as the server would send them.
function records(): Uint8Array[] {
  const bytes = streamBytes();
  const found: Uint8Array[] = [];
  for (let at = 0; at < bytes.length;) {
    const payload = Number(new DataView(bytes.buffer, at + 8, 8).getBigUint64(0, true));
    const end = at + 24 + 8 * Math.ceil(payload / 8);
    found.push(bytes.slice(at, end));
    at = end;
  }
  return found;
}

function answer(range: StreamRange, bytes: number): Response {
  const [header, ...rest] = records();
  const end = rest.pop() as Uint8Array;
  const frames = rest.filter((_, index) => index >= range.firstIndex && (index - range.firstIndex) % range.stride === 0);
  const whole = Uint8Array.from([header, ...frames, end].flatMap((record) => [...record]));
  return new Response(whole.slice(0, bytes));
}

function recorder(strides: number[] = []): { seen: string[]; sink: FrameSink } {
  const seen: string[] = [];
  return { seen, sink: {
    header: () => seen.push('header'),
    frame: (index) => {
      seen.push(`frame ${index}`);
      return strides.shift() ?? 1;
    },
    end: (end) => seen.push(`end ${end.state}`),
    trouble: (message) => { if (message) seen.push('trouble'); },
  } };
}

async function follow(open: (range: StreamRange, attempt: number) => Response, strides?: number[]): Promise<{ seen: string[]; asked: string[] }> {
  const { seen, sink } = recorder(strides);
  const asked: string[] = [];
  await followFrames(sink, {
    begin: async () => new AbortController(),
    open: async (range) => {
      asked.push(`${range.firstIndex}/${range.stride}`);
      return open(range, asked.length);
    },
    pause: async () => { if (asked.length > 20) throw new Error('asks for ever'); },
  }, new AbortController().signal);
  return { seen, asked };
}

describe('followFrames', () => {
  it('reads to the end', async () => {
    const { seen, asked } = await follow((range) => answer(range, Infinity));
    expect(seen).toEqual(['header', 'frame 0', 'frame 1', 'frame 2', 'end SUCCEEDED']);
    expect(asked).toEqual(['0/1']);
  });

  it('goes on behind the last complete frame when a stream breaks in the middle of one', async () => {
    const [header, first, second] = records();
    const cut = header.length + first.length + second.length / 2;
    const { seen, asked } = await follow((range, attempt) => answer(range, attempt === 1 ? cut : Infinity));
    expect(seen).toEqual(['header', 'frame 0', 'trouble', 'header', 'frame 1', 'frame 2', 'end SUCCEEDED']);
    expect(asked).toEqual(['0/1', '1/1']);
  });

  it('asks again where the server is away, and not where it refuses', async () => {
    const { asked } = await follow((range, attempt) => {
      if (attempt < 3) throw new ApiError(0, { message: 'away' });
      return answer(range, Infinity);
    });
    expect(asked).toHaveLength(3);
    await expect(follow(() => { throw new ApiError(404, { message: 'gone' }); })).rejects.toThrow('gone');
  });

  it('lets a stream go when nobody looks, and goes on where it was', async () => {
    const { seen, sink } = recorder();
    const asked: number[] = [];
    const attempts: AbortController[] = [];
    const [header, first, second] = records();
    const held = (signal: AbortSignal): Response => new Response(new ReadableStream({
      start: (stream) => {
        for (const record of [header, first, second]) stream.enqueue(record);
        signal.addEventListener('abort', () => stream.error(new DOMException('let go', 'AbortError')));
      },
    }));
    await followFrames({ ...sink, frame: (index, t, q) => {
      if (index === 1) setTimeout(() => attempts[0].abort());
      return sink.frame(index, t, q);
    } }, {
      begin: async () => {
        attempts.push(new AbortController());
        return attempts[attempts.length - 1];
      },
      open: async (range, signal) => {
        asked.push(range.firstIndex);
        return asked.length === 1 ? held(signal) : answer(range, Infinity);
      },
      pause: async () => { throw new Error('there is nothing to wait for'); },
    }, new AbortController().signal);
    expect(asked).toEqual([0, 2]);
    expect(seen).toEqual(['header', 'frame 0', 'frame 1', 'header', 'frame 2', 'end SUCCEEDED']);
    expect(attempts.every(({ signal }) => signal.aborted)).toBe(true);
  });

  it('asks again for more where a stream ends before its job', async () => {
    const more = new TextEncoder().encode('{"state":"RUNNING","reason":"NO_MORE_YET"}');
    const end = new Uint8Array(24 + 8 * Math.ceil(more.length / 8));
    new DataView(end.buffer).setUint32(0, 3, true);
    new DataView(end.buffer).setBigUint64(8, BigInt(more.length), true);
    end.set(more, 24);
    const [header, first] = records();
    const { seen, asked } = await follow((range, attempt) =>
      (attempt === 1 ? new Response(Uint8Array.from([...header, ...first, ...end])) : answer(range, Infinity)));
    expect(seen).toEqual(['header', 'frame 0', 'header', 'frame 1', 'frame 2', 'end SUCCEEDED']);
    expect(asked).toEqual(['0/1', '1/1']);
  });

  it('takes larger strides when the sink says so', async () => {
    const { seen, asked } = await follow((range) => answer(range, Infinity), [2, 2]);
    expect(seen).toEqual(['header', 'frame 0', 'header', 'frame 2', 'end SUCCEEDED']);
    expect(asked).toEqual(['0/1', '2/2']);
  });
});
