// SPDX-License-Identifier: MIT
import type { FrameStore } from './frame_store';

export const speeds = [0.05, 0.1, 0.25, 0.5, 1, 2] as const;

/// Which frame is shown, and how that moves on. Knows no clock: whoever has one calls advance.
export class Player {
  place = 0;
  playing = false;
  following = true;  // the newest frame is shown as it comes
  speed = 0.25;      // simulated s per s
  private t = 0;     // simulated time that is looked at; places change where frames are dropped

  constructor(private readonly store: FrameStore) {}

  /// A person chose a frame.
  seek(place: number): void {
    this.place = Math.max(0, Math.min(Math.round(place), this.store.count - 1));
    this.t = this.store.at(this.place)?.t ?? 0;
    this.following = false;
  }

  step(by: number): void {
    this.playing = false;
    this.seek(this.place + by);
  }

  /// From the start again where it stood at the end.
  play(): void {
    if (this.place >= this.store.count - 1) this.seek(0);
    this.following = false;
    this.playing = true;
    this.t = this.store.at(this.place)?.t ?? 0;
  }

  /// At the frame that is shown.
  pause(): void {
    this.playing = false;
    this.t = this.store.at(this.place)?.t ?? 0;
  }

  follow(): void {
    this.playing = false;
    this.following = true;
    this.framesCame();
  }

  framesCame(): void {
    if (this.following && this.store.count > 0) this.place = this.store.count - 1;
    else this.place = this.playing ? this.store.placeAt(this.t) : this.store.placeNear(this.t);
  }

  /// True when another frame is to be shown. `seconds`: since the last call, not more than a quarter is made up for.
  advance(seconds: number): boolean {
    if (!this.playing) return false;
    this.t += Math.min(seconds, 0.25) * this.speed;
    const before = this.place;
    this.place = this.store.placeAt(this.t);
    if (this.place >= this.store.count - 1) this.pause();
    return this.place !== before || !this.playing;
  }
}
