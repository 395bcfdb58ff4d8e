// SPDX-License-Identifier: MIT
import type { Frame } from '../fabric/fabric';
import { stitchFacts } from '../fabric/stitch_facts';
import { h } from '../ui/dom';
import type { Page } from '../ui/page';
import { downloadsPanel } from './downloads_panel';
import { jobHead } from './job_head';
import { JobModel } from './job_model';
import { plotsPanel } from './plots_panel';
import { stitchPanel } from './stitch_panel';
import { studyView } from './study_view';
import { summaryPanel } from './summary_panel';
import { watchView } from './watch_view';

export function jobPage(id: string): Page {
  const model = new JobModel(id);
  const state: { stitch: number; frame?: Frame } = { stitch: -1 };

  const showStitch = (): void => {
    const fabric = model.fabric.value;
    const known = fabric && state.frame && state.stitch >= 0 && state.stitch < fabric.stitches.length;
    stitch.show(known ? stitchFacts(fabric, state.frame as Frame, model.store.first ?? (state.frame as Frame), state.stitch) : undefined);
  };
  const choose = (index: number): void => {
    state.stitch = index;
    watch.choose(index);
    showStitch();
  };
  const stitch = stitchPanel((course, wale) => {
    const fabric = model.fabric.value;
    if (!fabric) return 'There is no fabric yet.';
    const found = fabric.stitches.findIndex((candidate) => candidate.course === course && candidate.wale === wale);
    if (found < 0) return fabric.stitches.length === 0 ? 'This fabric has no stitches.'
      : `There is no such stitch: courses go from 1 to ${fabric.numCourses}, wales from 1 to ${fabric.numWales}.`;
    choose(found);
    return undefined;
  }, () => choose(-1));
  const watch = watchView(model, {
    frame: (frame) => {
      state.frame = frame;
      showStitch();
      plots.showTime(frame.t);
      downloads.showFrame(frame);
    },
    picked: choose,
  });
  const plots = plotsPanel(model);
  const downloads = downloadsPanel(model, () => watch.picture());
  const side = h('div', { class: 'side' }, stitch.element, plots.element, downloads.element, summaryPanel(model));
  const columns = h('div', { class: 'job-columns' }, watch.element, side);
  const element = h('div', { class: 'page job-page' }, jobHead(model), columns);
  const unlessStudy = model.job.subscribe((job) => {
    if (!job) return;
    unlessStudy();
    if (!job.study) return;
    watch.leave();
    columns.replaceWith(studyView(model));
  });
  model.missing.subscribe((missing) => {
    if (!missing) return;
    element.replaceChildren(h('div', { class: 'page-head' }, h('h1', {}, id)), h('p', { class: 'error-box', role: 'alert' }, model.fault.value),
      h('p', {}, h('a', { href: '#/jobs' }, 'All jobs')));
  });
  model.start();
  return {
    title: `Job ${id}`,
    element,
    leave: () => {
      model.end();
      watch.leave();
      downloads.leave();
    },
  };
}
