// SPDX-License-Identifier: MIT
import { hasEnded, type JobProgress, type JobState, type SimJob } from '../api/messages';
import { frameText } from '../player/frame_text';
import { shortNumber } from '../scene/number_text';

const words: Partial<Record<JobState, string>> = {
  QUEUED: 'Queued', RUNNING: 'Running', SUCCEEDED: 'Done', FAILED: 'Failed', CANCELLED: 'Cancelled', PAUSED: 'Paused',
};

export function stateText(job: SimJob): string {
  const text = words[job.state ?? 'STATE_UNSPECIFIED'] ?? 'Unknown';
  return job.cancel_requested && job.state === 'RUNNING' ? 'Cancelling' : text;
}

/// "1 h 05 min", "3 min 20 s", "12 s", "0.4 s".
export function spanText(seconds: number): string {
  if (!Number.isFinite(seconds) || seconds < 0) return '–';
  if (seconds < 10) return `${seconds.toFixed(1)} s`;
  const whole = Math.round(seconds);
  if (whole < 60) return `${whole} s`;
  if (whole < 3600) return `${Math.floor(whole / 60)} min ${String(whole % 60).padStart(2, '0')} s`;
  return `${Math.floor(whole / 3600)} h ${String(Math.floor((whole % 3600) / 60)).padStart(2, '0')} min`;
}

const simulating = 'simulating';  // what a job does that is at its simulation itself

/// What it does.
export function workText(job: SimJob): string {
  return job.study ? (job.study.quick ? 'Quick study' : 'Study') : 'Simulation';
}

/// From 0 to 1.
export function partDone(progress: JobProgress): number {
  return Math.min(progress.share_done ?? 0, 1);
}

export function progressText(job: SimJob, progress = job.progress): string {
  if (!progress) return job.state === 'QUEUED' ? 'waits for a free place' : job.state === 'RUNNING' ? 'starts' : '';
  const { t = 0, duration_s: duration = 0, frames = 0, num_frames: planned = 0, eta_s: left, wall_s: wall = 0 } = progress;
  const before = job.state === 'RUNNING' && progress.doing && progress.doing !== simulating;
  const parts = job.study ? [`${Math.floor(100 * partDone(progress))} %`, ...(progress.doing ? [progress.doing] : [])]
    : before ? [progress.doing ?? ''] : [`${Number(t.toPrecision(3))} of ${duration} s`, frames > 0 || !hasEnded(job.state) ? frameText(frames - 1, planned) : 'no frames'];
  if (job.state === 'RUNNING') parts.push(left === undefined ? 'time left not known yet' : `${spanText(left)} left`);
  else parts.push(`took ${spanText(wall)}`);
  if (progress.error_estimate_m !== undefined) parts.push(`error about ${shortNumber(1e3 * progress.error_estimate_m)} mm`);
  return parts.join(' · ');
}
