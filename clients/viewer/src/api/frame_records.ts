// SPDX-License-Identifier: MIT
// The binary frame stream: records of 24 bytes (u32 kind, u32 index, u64 payload bytes, f64 t in s, little endian), then
// the payload, padded with zeros to a multiple of 8.
import type { FrameHeaderMessage, StreamEnd } from './messages';

export type FrameRecord =
  | { kind: 'header'; header: FrameHeaderMessage }
  | { kind: 'frame'; index: number; t: number; q: Float64Array }
  | { kind: 'end'; end: StreamEnd };

const headBytes = 24;
const kinds = { header: 1, frame: 2, end: 3 };

/// A record cannot be longer: more is a broken stream, not something to wait and buy memory for.
export const maxPayloadBytes = 1 << 30;

interface Head {
  kind: number;
  index: number;
  payload: number;
  t: number;
}

function readHead(bytes: Uint8Array): Head {
  const view = new DataView(bytes.buffer, bytes.byteOffset, headBytes);
  const payload = view.getBigUint64(8, true);
  if (payload > BigInt(maxPayloadBytes)) throw new Error(`a record of ${payload} bytes, expected at most ${maxPayloadBytes}`);
  return {
    kind: view.getUint32(0, true),
    index: view.getUint32(4, true),
    payload: Number(payload),
    t: view.getFloat64(16, true),
  };
}

function readPayload(head: Head, bytes: Uint8Array): FrameRecord | undefined {
  if (head.kind === kinds.frame) {
    if (head.payload % 8 !== 0) throw new Error(`frame ${head.index} has ${head.payload} bytes, expected a multiple of 8`);
    const copy = bytes.slice(0, head.payload);
    return { kind: 'frame', index: head.index, t: head.t, q: new Float64Array(copy.buffer, 0, head.payload / 8) };
  }
  if (head.kind !== kinds.header && head.kind !== kinds.end) return undefined;  // keep-alive, or newer than this viewer
  const message: unknown = JSON.parse(new TextDecoder().decode(bytes.subarray(0, head.payload)));
  return head.kind === kinds.header
    ? { kind: 'header', header: message as FrameHeaderMessage }
    : { kind: 'end', end: message as StreamEnd };
}

/// Takes the bytes of a stream in pieces of any size and gives the records that they complete.
export class FrameRecordDecoder {
  private pieces: Uint8Array[] = [];
  private pending = 0;  // bytes in pieces
  private head: Head | undefined;

  push(bytes: Uint8Array): FrameRecord[] {
    this.pieces.push(bytes);
    this.pending += bytes.length;
    const records: FrameRecord[] = [];
    for (;;) {
      if (!this.head) {
        if (this.pending < headBytes) break;
        this.head = readHead(this.take(headBytes));
      }
      const padded = Math.ceil(this.head.payload / 8) * 8;
      if (this.pending < padded) break;
      const record = readPayload(this.head, this.take(padded));
      if (record) records.push(record);
      this.head = undefined;
    }
    return records;
  }

  /// Joins pieces only once all of a record is there, so that a frame in many pieces costs its size, not its square.
  private take(count: number): Uint8Array {
    const bytes = new Uint8Array(count);
    let filled = 0;
    while (filled < count) {
      const piece = this.pieces[0];
      const used = Math.min(piece.length, count - filled);
      bytes.set(piece.subarray(0, used), filled);
      filled += used;
      if (used === piece.length) this.pieces.shift();
      else this.pieces[0] = piece.subarray(used);
    }
    this.pending -= count;
    return bytes;
  }
}
