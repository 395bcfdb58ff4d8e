// SPDX-License-Identifier: MIT
// data/: scene.json run by slipstitchd; its frames as one binary stream and two of them as the exporter wrote them
// (slipstitch frames --format json).
import { readFileSync } from 'node:fs';
import { FrameRecordDecoder } from '../src/api/frame_records';
import { makeFabric, type Fabric, type Frame } from '../src/fabric/fabric';

function read(name: string): Buffer {
  return readFileSync(new URL(`data/${name}`, import.meta.url));
}

export function streamBytes(): Uint8Array {
  return new Uint8Array(read('stream.bin'));
}

export interface ExportedFrame {
  frame: number;
  t_s: number;
  radius_m: number;
  yarns: { points_m: number[][]; arc_length_m: number[]; slid_m: number[]; tension_n: number[] }[];
  wrap_rad: (number | null)[][];
}

export function exportedFrame(index: number): ExportedFrame {
  return JSON.parse(read(`frame_${index}.json`).toString()) as ExportedFrame;
}

export function goldenRun(): { fabric: Fabric; frames: Frame[] } {
  const records = new FrameRecordDecoder().push(streamBytes());
  const [header] = records;
  if (header.kind !== 'header') throw new Error('no header first');
  return { fabric: makeFabric(header.header), frames: records.filter((record) => record.kind === 'frame') };
}
