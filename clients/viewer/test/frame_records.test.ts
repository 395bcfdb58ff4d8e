// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { FrameRecordDecoder, maxPayloadBytes, type FrameRecord } from '../src/api/frame_records';
import { streamBytes } from './golden';

function head(kind: number, index: number, payload: number | bigint, t: number): Uint8Array {
  const view = new DataView(new ArrayBuffer(24));
  view.setUint32(0, kind, true);
  view.setUint32(4, index, true);
  view.setBigUint64(8, BigInt(payload), true);
  view.setFloat64(16, t, true);
  return new Uint8Array(view.buffer);
}

function inPieces(bytes: Uint8Array, size: number): FrameRecord[] {
  const decoder = new FrameRecordDecoder();
  const records: FrameRecord[] = [];
  for (let at = 0; at < bytes.length; at += size) records.push(...decoder.push(bytes.subarray(at, at + size)));
  return records;
}

describe('FrameRecordDecoder', () => {
  it('reads header, frames and end of a stream', () => {
    const records = inPieces(streamBytes(), 1 << 20);
    expect(records.map((record) => record.kind)).toEqual(['header', 'frame', 'frame', 'frame', 'end']);
    expect(records.map((record) => (record.kind === 'frame' ? [record.index, record.t] : []))).toEqual([[], [0, 0], [1, 0.05], [2, 0.1], []]);
    const end = records[4];
    expect(end.kind === 'end' && end.end.state).toBe('SUCCEEDED');
  });

  it.each([1, 7, 24, 1000])('reads the same from pieces of %i bytes', (size) => {
    expect(inPieces(streamBytes(), size)).toEqual(inPieces(streamBytes(), 1 << 20));
  });

  it('gives nothing for a record that is not complete', () => {
    expect(inPieces(streamBytes().subarray(0, 200), 50)).toEqual([]);
  });

  it('skips keep-alives and kinds it does not know, padding included', () => {
    const unknown = [...head(9, 0, 3, 0), 1, 2, 3, 0, 0, 0, 0, 0];
    const frame = [...head(2, 5, 8, 0.25), ...new Uint8Array(new Float64Array([1.5]).buffer)];
    const records = inPieces(Uint8Array.from([...head(0, 0, 0, 0), ...unknown, ...frame]), 11);
    expect(records).toEqual([{ kind: 'frame', index: 5, t: 0.25, q: new Float64Array([1.5]) }]);
  });

  it('refuses a length that no record has, before waiting for it', () => {
    expect(() => inPieces(head(2, 0, BigInt(maxPayloadBytes) + 8n, 0), 24)).toThrow(/expected at most/);
  });

  it('refuses a frame that is no row of doubles', () => {
    expect(() => inPieces(Uint8Array.from([...head(2, 3, 5, 0), 0, 0, 0, 0, 0, 0, 0, 0]), 64)).toThrow(/frame 3 has 5 bytes/);
  });
});
