// SPDX-License-Identifier: MIT
// All that the page of a job knows, kept up to date from the server: state -> views.
import { ApiError } from '../api/api_error';
import { followFrames, type FrameSink } from '../api/follow_frames';
import { hasEnded, type SimJob } from '../api/messages';
import { artefactText, getSimJob, openFrameStream } from '../api/sim_jobs';
import { takeStreamTurn } from '../api/stream_turn';
import { makeFabric, stateLength, type Fabric } from '../fabric/fabric';
import { FrameStore } from '../player/frame_store';
import { parseHistory, type History } from '../plots/history';
import type { Json } from '../scene/field';
import { askWhileSeen, sleep, whileSeen } from '../ui/presence';
import { Signal } from '../ui/signal';

const askEveryMs = 1000;
const askEndedEveryMs = 5000;  // it can still be deleted

export class JobModel {
  readonly job = new Signal<SimJob | undefined>(undefined);
  readonly fabric = new Signal<Fabric | undefined>(undefined);
  readonly scene = new Signal<Json | undefined>(undefined);
  readonly history = new Signal<History | undefined>(undefined);
  readonly trouble = new Signal<string>('');   // with the stream of frames; it is being seen to
  readonly lost = new Signal<string>('');      // likewise, with the server
  readonly gone = new Signal(false);           // the job is no longer on the server
  readonly missing = new Signal(false);        // the server never had it, as far as this page knows
  readonly crowded = new Signal(false);        // too many windows: frames come in turns
  readonly fault = new Signal<string>('');     // for good
  readonly store = new FrameStore();
  readonly frames = new Signal(0);             // how many came
  readonly streamEnded = new Signal(false);
  private readonly stop = new AbortController();
  private historyBusy = false;
  private historyWanted = false;
  private haveAnswer: () => void = () => undefined;
  private readonly answered = new Promise<void>((resolve) => { this.haveAnswer = resolve; });  // once, to ask()

  constructor(readonly id: string) {}

  start(): void {
    this.loadScene();
    const { signal } = this.stop;
    const asking = askWhileSeen(() => this.ask().finally(this.haveAnswer), () => (hasEnded(this.job.value?.state) ? askEndedEveryMs : askEveryMs), signal);
    void this.follow(signal, asking);
  }

  /// What has frames: that is known with the first answer about the job.
  private async follow(signal: AbortSignal, asking: Promise<void>): Promise<void> {
    await Promise.race([this.answered, asking]);
    if (this.job.value?.study) {
      this.streamEnded.set(true);
      return;
    }
    followFrames(this.sink(), {
      begin: whileSeen,
      open: async (range, attempt) => openFrameStream(this.id, range, await this.mayStayOpen(attempt), attempt),
      pause: sleep,
    }, signal).catch((error: unknown) => this.failed(error));
  }

  /// Answers overtake each other: what is older than what is known is left.
  learn(job: SimJob): void {
    if (BigInt(job.revision ?? 0) >= BigInt(this.job.value?.revision ?? 0)) this.job.set(job);
  }

  end(): void {
    this.stop.abort();
  }

  private async mayStayOpen(attempt: AbortSignal): Promise<boolean> {
    const mine = await takeStreamTurn(attempt);
    this.crowded.set(!mine);
    return mine;
  }

  /// True: there is no use in asking again.
  private async ask(): Promise<boolean> {
    const before = this.job.value;
    try {
      const job = await getSimJob(this.id);
      if (this.stop.signal.aborted) return true;
      this.lost.set('');
      this.learn(job);
      if (job.progress?.frames !== before?.progress?.frames || job.state !== before?.state) this.loadHistory();
      return false;
    } catch (error) {
      if (error instanceof ApiError && error.httpStatus === 404) {
        if (before) this.forget();
        else this.miss(error);
        return true;
      }
      this.lost.set('The connection to the server broke; trying again.');
      return false;
    }
  }

  private forget(): void {
    this.gone.set(true);
    this.end();
    this.streamEnded.set(true);
    for (const signal of [this.lost, this.trouble]) signal.set('');
    this.fault.set('This job was deleted, by another window or program. What this window has of it can still be watched.');
  }

  private miss(error: ApiError): void {
    this.end();
    this.fault.set(error.message);
    this.missing.set(true);
  }

  private sink(): FrameSink {
    return {
      header: (header) => {
        if (!this.fabric.value) this.fabric.set(makeFabric(header));
      },
      frame: (index, t, q) => {
        const fabric = this.fabric.value;
        if (!fabric || q.length !== stateLength(fabric)) throw new ApiError(400, { message: `frame ${index} does not fit the header` });
        const stride = this.store.add({ index, t, q });
        this.frames.set(this.frames.value + 1);
        return stride;
      },
      end: () => this.streamEnded.set(true),
      trouble: (message) => this.trouble.set(message ? `${message}; trying again.` : ''),
    };
  }

  private loadScene(): void {
    artefactText(this.id, 'scene.json').then((text) => {
      const spec = JSON.parse(text) as { scene?: Json };
      this.scene.set(spec.scene ?? spec as Json);
    }).catch((error: unknown) => {
      if (!(error instanceof ApiError && error.httpStatus === 404)) this.trouble.set(`scene.json cannot be read: ${String(error)}`);
    });
  }

  private loadHistory(): void {
    if (this.job.value?.study) return;
    this.historyWanted = true;
    if (this.historyBusy) return;
    this.historyBusy = true;
    this.historyWanted = false;
    const begun = performance.now();
    artefactText(this.id, 'history.csv')
      .then((text) => this.history.set(parseHistory(text)))
      .catch(() => undefined)  // a job that has not begun has none
      .then(() => sleep(Math.max(300, 10 * (performance.now() - begun)), this.stop.signal))  // long ones seldom
      .then(() => {
        this.historyBusy = false;
        if (this.historyWanted && !this.stop.signal.aborted) this.loadHistory();
      });
  }

  private failed(error: unknown): void {
    if (this.gone.value) return;
    this.fault.set(error instanceof Error ? error.message : String(error));
  }
}
