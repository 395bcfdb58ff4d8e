// SPDX-License-Identifier: MIT
// All that the page of a job knows, kept up to date from the server: state -> views.
import { ApiError } from '../api/api_error';
import { followFrames, type FrameSink } from '../api/follow_frames';
import { hasEnded, type JobProgress, type SimJob } from '../api/messages';
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
const historyEveryMs = 300;    // at most
const historyAgainMs = 2000;   // where it could not be had

export class JobModel {
  readonly job = new Signal<SimJob | undefined>(undefined);
  readonly fabric = new Signal<Fabric | undefined>(undefined);
  readonly scene = new Signal<Json | undefined>(undefined);
  readonly history = new Signal<History | undefined>(undefined);
  readonly historyWhole = new Signal(false);   // nothing will come after it
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
  readonly left = this.stop.signal;            // aborts when there is nothing more to ask
  private readonly ended = new AbortController();  // aborts when the job has ended or the page is left
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
    const before = this.job.value;
    if (BigInt(job.revision ?? 0) < BigInt(before?.revision ?? 0)) return;
    this.job.set(job);
    if (hasEnded(job.state)) this.ended.abort();
    if (job.progress?.frames !== before?.progress?.frames || job.state !== before?.state) this.loadHistory();
  }

  /// How far the run is, from the job or the frames that came: the larger of both, as neither waits for the other.
  progress(): JobProgress | undefined {
    const [told, last] = [this.job.value?.progress, this.store.last];
    if (!told || !last) return told;
    const t = Math.max(told.t ?? 0, last.t);
    const share = told.duration_s ? t / told.duration_s : 0;
    return { ...told, t, share_done: Math.max(told.share_done ?? 0, share), frames: Math.max(told.frames ?? 0, last.index + 1) };
  }

  end(): void {
    this.stop.abort();
    this.ended.abort();
  }

  private async mayStayOpen(attempt: AbortSignal): Promise<boolean> {
    const mine = await takeStreamTurn(attempt);
    this.crowded.set(!mine);
    return mine;
  }

  /// True: there is no use in asking again.
  private async ask(): Promise<boolean> {
    try {
      const job = await getSimJob(this.id);
      if (this.stop.signal.aborted) return true;
      this.lost.set('');
      this.learn(job);
      return false;
    } catch (error) {
      if (error instanceof ApiError && error.httpStatus === 404) {
        if (this.job.value) this.forget();
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
        this.loadHistory();
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
    if (!this.historyBusy) void this.readHistories();
  }

  /// Reads the history for as long as somebody wants it, long ones seldom, and the whole one at once when the job has ended.
  private async readHistories(): Promise<void> {
    this.historyBusy = true;
    while (this.historyWanted && !this.historyWhole.value) {
      const seen = await whileSeen(this.stop.signal);
      seen.abort();
      if (this.stop.signal.aborted) break;
      this.historyWanted = false;
      const begun = performance.now();
      if (await this.readHistory()) await sleep(Math.max(historyEveryMs, 10 * (performance.now() - begun)), this.ended.signal);
      else await sleep(historyAgainMs, this.stop.signal);
    }
    this.historyBusy = false;
  }

  /// False: asking again may help.
  private async readHistory(): Promise<boolean> {
    const ended = hasEnded(this.job.value?.state);
    try {
      this.history.set(parseHistory(await artefactText(this.id, 'history.csv')));
    } catch (error) {
      this.historyWanted = !(error instanceof ApiError && error.httpStatus === 404);  // a job that has not begun has none
      if (this.historyWanted) return false;
    }
    this.historyWhole.set(ended);
    return true;
  }

  private failed(error: unknown): void {
    if (this.gone.value) return;
    this.fault.set(error instanceof Error ? error.message : String(error));
  }
}
