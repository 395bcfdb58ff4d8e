// SPDX-License-Identifier: MIT
import { ApiError } from './api_error';
import { FrameRecordDecoder, type FrameRecord } from './frame_records';
import { hasEnded, type FrameHeaderMessage, type StreamEnd } from './messages';
import type { StreamRange } from './sim_jobs';

export interface FrameSink {
  header(header: FrameHeaderMessage): void;
  /// The answer is the stride to go on with; another one than before opens the stream anew.
  frame(index: number, t: number, q: Float64Array): number;
  end(end: StreamEnd): void;
  /// The stream broke and will be opened again; `undefined`: it flows.
  trouble(message: string | undefined): void;
}

export interface FollowOptions {
  /// Waits until frames are wanted. The answer aborts when they no longer are, and is aborted once its stream is done.
  begin(signal: AbortSignal): Promise<AbortController>;
  /// A stream that follows the job, or one that ends with what there is.
  open(range: StreamRange, signal: AbortSignal): Promise<Response>;
  pause(ms: number, signal: AbortSignal): Promise<void>;
}

const firstPauseMs = 250;
const longestPauseMs = 5000;
const pauseForMoreMs = 2000;

type Outcome = 'ended' | 'no more yet' | 'broken';

class Restride extends Error {}

/// Reads one stream to its end. `range` is kept at what comes next.
async function readOnce(range: StreamRange, sink: FrameSink, options: FollowOptions, signal: AbortSignal): Promise<Outcome> {
  const response = await options.open(range, signal);
  if (!response.body) throw new Error('the answer has no body');
  const reader = response.body.getReader();
  const decoder = new FrameRecordDecoder();
  try {
    for (;;) {
      const { done, value } = await reader.read();
      if (done) return 'broken';
      sink.trouble(undefined);
      for (const record of decoder.push(value)) {
        const outcome = handle(record, range, sink);
        if (outcome) return outcome;
      }
    }
  } finally {
    reader.cancel().catch(() => undefined);
  }
}

function handle(record: FrameRecord, range: StreamRange, sink: FrameSink): Outcome | undefined {
  if (record.kind === 'header') sink.header(record.header);
  if (record.kind === 'end') {
    if (!hasEnded(record.end.state)) return 'no more yet';
    sink.end(record.end);
    return 'ended';
  }
  if (record.kind !== 'frame') return undefined;
  const stride = sink.frame(record.index, record.t, record.q);
  const changed = stride !== range.stride;
  range.stride = stride;
  range.firstIndex = Math.floor(record.index / stride + 1) * stride;
  if (changed) throw new Restride();
  return undefined;
}

/// Gives every frame of a job to the sink, following it while it runs, over as many streams as that takes. Ends when the
/// stream says that the job ended, when the signal aborts, or throws ApiError when asking again would not help.
export async function followFrames(sink: FrameSink, options: FollowOptions, signal: AbortSignal): Promise<void> {
  const range: StreamRange = { firstIndex: 0, stride: 1 };
  let pauseMs = firstPauseMs;
  while (!signal.aborted) {
    const before = range.firstIndex;
    const attempt = await options.begin(signal);
    let outcome: Outcome = 'broken';
    try {
      outcome = await readOnce(range, sink, options, attempt.signal);
      if (outcome === 'ended') return;
      if (outcome === 'broken') sink.trouble('the stream of frames broke off');
    } catch (error) {
      if (signal.aborted) return;
      if (attempt.signal.aborted || error instanceof Restride) continue;
      if (error instanceof ApiError && error.httpStatus >= 400 && error.httpStatus < 500 && error.httpStatus !== 429) throw error;
      sink.trouble(error instanceof Error ? error.message : String(error));
    } finally {
      attempt.abort();
    }
    pauseMs = outcome === 'no more yet' ? pauseForMoreMs : range.firstIndex > before ? firstPauseMs : Math.min(2 * pauseMs, longestPauseMs);
    await options.pause(pauseMs, signal);
  }
}
