// SPDX-License-Identifier: MIT
// What a study found, in place of the picture and the player of a simulation.
import { hasEnded, type SimJob } from '../api/messages';
import { artefactAddress, shownArtefactAddress } from '../api/sim_jobs';
import { h } from '../ui/dom';
import { fileList } from './file_list';
import type { JobModel } from './job_model';
import { summaryPanel } from './summary_panel';

const page = 'study.html';
const plots: readonly [string, string][] = [
  ['error-time.svg', 'Error of positions against wall time, a line for each method'],
  ['error-newton.svg', 'Error of positions against Newton iterations, a line for each method'],
];

/// Whether its plots have anything to show.
function hasErrors(job: SimJob | undefined): boolean {
  if (!job?.summary_json) return false;
  const { study } = JSON.parse(job.summary_json) as { study?: { rungs?: { position_error_m?: number | null }[] } };
  return (study?.rungs ?? []).some((rung) => typeof rung.position_error_m === 'number');
}

export function studyView(model: JobModel): HTMLElement {
  const files = fileList(model);
  const note = h('p', { class: 'note', role: 'status' });
  const report = h('div', { class: 'study-report' });
  const show = (): void => {
    const known = files.names.value !== undefined;
    const there = files.names.value?.includes(page) === true && !model.gone.value;
    const ended = hasEnded(model.job.value?.state);
    const compared = hasErrors(model.job.value);
    note.hidden = there && compared;
    note.textContent = model.gone.value ? 'The report is gone with the job.'
      : there ? 'No way to run the scene could be compared with another; the report says why.'
      : ended && !known ? 'Asking for the report …'
      : ended ? 'This study has no report.' : 'The scene is run in many ways; the report comes when all of them are done.';
    report.replaceChildren(...(there ? [
      h('p', { class: 'links' }, h('a', { class: 'button', href: shownArtefactAddress(model.id, page), target: '_blank', rel: 'noopener' }, 'Open the report')),
      ...(compared ? plots : []).map(([file, what]) => h('img', { src: artefactAddress(model.id, file), alt: what })),
    ] : []));
  };
  const filesPanel = h('section', { class: 'panel', 'aria-label': 'Downloads' }, h('h2', {}, 'Downloads'), files.element);
  for (const signal of [files.names, model.gone]) signal.subscribe(show);
  model.job.subscribe((job) => {
    if (note.dataset.state === job?.state) return;  // or the plots would be drawn anew with every answer
    note.dataset.state = job?.state ?? '';
    show();
  });
  model.gone.subscribe((gone) => { filesPanel.hidden = gone; });
  return h('div', { class: 'job-columns' },
    h('section', { class: 'panel', 'aria-label': 'Study' }, h('h2', {}, 'Accuracy against time'), note, report),
    h('div', { class: 'side' }, summaryPanel(model), filesPanel));
}
