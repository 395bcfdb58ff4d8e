// SPDX-License-Identifier: MIT
import type { Frame } from '../fabric/fabric';

export const defaultBoundBytes = 512 * 1024 * 1024;

/// The frames of a job, as doubles, within a bound. Where they would take more, every other one is dropped, so that what
/// is kept still spans all of the time.
export class FrameStore {
  private frames: Frame[] = [];
  private bytes = 0;
  private currentStride = 1;

  constructor(private readonly boundBytes = defaultBoundBytes) {}

  /// Every stride-th frame is kept.
  get stride(): number {
    return this.currentStride;
  }

  get count(): number {
    return this.frames.length;
  }

  get last(): Frame | undefined {
    return this.frames[this.frames.length - 1];
  }

  get first(): Frame | undefined {
    return this.frames[0];
  }

  at(place: number): Frame | undefined {
    return this.frames[place];
  }

  /// Frames come in ascending order; one that is here already is left as it is. The answer is the stride to go on with.
  add(frame: Frame): number {
    const last = this.last;
    if (last && frame.index <= last.index) return this.currentStride;
    if (frame.index % this.currentStride !== 0) return this.currentStride;
    this.frames.push(frame);
    this.bytes += frame.q.byteLength;
    while (this.bytes > this.boundBytes && this.frames.length > 2) this.thin();
    return this.currentStride;
  }

  /// The place of the last frame at or before a simulated time.
  placeAt(t: number): number {
    let [low, high] = [0, this.frames.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.frames[middle].t <= t) low = middle + 1;
      else high = middle;
    }
    return Math.max(low - 1, 0);
  }

  /// The place of the frame nearest to a simulated time, of two the earlier.
  placeNear(t: number): number {
    const place = this.placeAt(t);
    const [before, after] = [this.frames[place], this.frames[place + 1]];
    return after && after.t - t < Math.abs(t - before.t) ? place + 1 : place;
  }

  private thin(): void {
    this.currentStride *= 2;
    this.frames = this.frames.filter((frame) => frame.index % this.currentStride === 0);
    this.bytes = this.frames.reduce((sum, frame) => sum + frame.q.byteLength, 0);
  }
}
