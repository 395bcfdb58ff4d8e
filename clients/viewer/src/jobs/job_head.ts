// SPDX-License-Identifier: MIT
import { hasEnded } from '../api/messages';
import { cancelSimJob, deleteSimJob } from '../api/sim_jobs';
import { button, h } from '../ui/dom';
import type { JobModel } from './job_model';
import { partDone, progressText, stateText, workText } from './job_text';

function errorText(model: JobModel): string {
  const error = model.job.value?.error;
  if (!error) return '';
  const reason = error.details?.find((detail) => detail.reason)?.reason;
  return reason ? `${error.message} (${reason})` : error.message ?? 'It failed.';
}

/// Name, state, progress and what can be done with the job.
export function jobHead(model: JobModel): HTMLElement {
  const title = h('h1', {}, model.id);
  const state = h('span', { class: 'state', role: 'status' });
  const work = h('span', { class: 'job-work' });
  const progress = h('progress', { max: 1, value: 0, 'aria-label': 'Progress' });
  const text = h('span', { class: 'progress-text' });
  const trouble = h('p', { class: 'status', role: 'status' });
  const fault = h('p', { class: 'error-box', role: 'alert', hidden: true });
  const say = (error: unknown): void => model.fault.set(error instanceof Error ? error.message : String(error));
  const cancel = button('Cancel', () => void cancelSimJob(model.id).then((job) => model.learn(job), say), { hidden: true });
  const remove = button('Delete', () => {
    if (!window.confirm(`Delete this job and its ${model.job.value?.study ? 'report' : 'frames'}?`)) return;
    deleteSimJob(model.id).then(() => { location.hash = '#/jobs'; }, say);
  }, { hidden: true });
  const again = h('a', { class: 'button', href: `#/new/${model.id}`, hidden: true }, 'Edit a copy');

  const showJob = (): void => {
    const job = model.job.value;
    if (!job) return;
    const gone = model.gone.value;
    const ended = hasEnded(job.state);
    title.textContent = job.scene_name || model.id;
    state.textContent = gone ? 'Deleted' : stateText(job);
    state.className = `state state-${gone ? 'deleted' : (job.state ?? '').toLowerCase()}`;
    work.textContent = workText(job);
    showProgressSoon();
    again.hidden = gone;
    cancel.hidden = ended || gone;
    cancel.disabled = job.cancel_requested === true;
    remove.hidden = !ended || gone;
    showFault();
  };
  /// With the next picture of the screen, as the player does, so that both tell of the same frame.
  const asked = { request: 0 };
  function showProgressSoon(): void {
    if (asked.request === 0) asked.request = requestAnimationFrame(showProgress);
  }
  function showProgress(): void {
    asked.request = 0;
    const job = model.job.value;
    if (!job) return;
    progress.value = job.state === 'SUCCEEDED' ? 1 : partDone(model.progress() ?? {});
    const now = progressText(job, model.progress());
    if (text.textContent !== now) text.textContent = now;
  }
  model.job.subscribe(showJob);
  model.frames.subscribe(showProgressSoon);
  model.gone.subscribe(showJob);
  const showTrouble = (): void => {
    const crowded = model.crowded.value && !model.gone.value && !hasEnded(model.job.value?.state) && 'Several windows follow runs: in this one frames come every 2 s.';
    trouble.textContent = model.lost.value || model.trouble.value || crowded || '';
  };
  for (const signal of [model.lost, model.trouble, model.crowded, model.gone, model.job]) signal.subscribe(showTrouble);
  model.fault.subscribe(showFault);
  function showFault(): void {
    const message = model.fault.value || errorText(model);
    fault.textContent = message;
    fault.hidden = message === '';
  }
  return h('div', { class: 'job-head' },
    h('div', { class: 'page-head' }, title, state, work, h('span', { class: 'job-id' }, model.id), h('span', { class: 'push' }), again, cancel, remove),
    h('div', { class: 'progress-row' }, progress, text), trouble, fault);
}
