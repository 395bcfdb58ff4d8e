// SPDX-License-Identifier: MIT
import { artefactAddress } from '../api/sim_jobs';
import { plotsOf } from '../plots/history';
import { plotFigure, type PlotFigure } from '../plots/plot';
import { h } from '../ui/dom';
import type { JobModel } from './job_model';

export interface PlotsPanel {
  element: HTMLElement;
  showTime(t: number): void;
}

export function plotsPanel(model: JobModel): PlotsPanel {
  const frame = h('div', { class: 'plots' });
  const empty = h('p', { class: 'note' });
  const state = { now: 0, sinceStart: true, figures: [] as PlotFigure[] };
  const draw = (): void => {
    const history = model.history.value;
    const plots = history && history.rows > 1 ? plotsOf(history, state.sinceStart) : [];
    state.figures = plots.map(plotFigure);
    empty.hidden = plots.length > 0;
    empty.textContent = model.historyWhole.value ? 'There is nothing to plot: the job ended before its second frame.' : 'Plots appear once the run has written its history.';
    sinceStart.hidden = plots.length === 0;
    frame.replaceChildren(...state.figures.map((figure) => figure.element));
    for (const figure of state.figures) figure.showTime(state.now);
  };
  const box = h('input', { type: 'checkbox', id: 'since-start', checked: true });
  box.addEventListener('change', () => {
    state.sinceStart = box.checked;
    draw();
  });
  const sinceStart = h('p', { class: 'links' }, box, h('label', { for: box.id }, 'energies as change since the start'));
  model.history.subscribe(draw);
  model.historyWhole.subscribe(draw);
  const link = h('p', {}, h('a', { href: artefactAddress(model.id, 'history.csv'), download: `${model.id}-history.csv` }, 'Download as CSV'));
  const showLink = (): void => { link.hidden = model.gone.value || model.history.value === undefined; };
  model.history.subscribe(showLink);
  model.gone.subscribe(showLink);
  return {
    element: h('section', { class: 'panel', 'aria-label': 'Plots' }, h('h2', {}, 'Plots'), empty, sinceStart, frame, link),
    showTime: (t) => {
      state.now = t;
      for (const figure of state.figures) figure.showTime(t);
    },
  };
}
