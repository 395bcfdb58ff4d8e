// SPDX-License-Identifier: MIT
import { ApiError } from '../api/api_error';
import { hasEnded, jobId, type SimJob } from '../api/messages';
import { cancelSimJob, deleteSimJob, listSimJobs } from '../api/sim_jobs';
import { button, h, select } from '../ui/dom';
import type { Page } from '../ui/page';
import { askWhileSeen } from '../ui/presence';
import { progressText, stateText, workText } from './job_text';

const refreshMs = 2000;
const states: [string, string][] = [['', 'all'], ['QUEUED', 'queued'], ['RUNNING', 'running'], ['SUCCEEDED', 'done'],
  ['FAILED', 'failed'], ['CANCELLED', 'cancelled']];

function timeElement(time: string | undefined): HTMLElement | string {
  return time ? h('time', { datetime: time }, new Date(time).toLocaleString()) : '–';
}

export function jobListPage(): Page {
  const stop = new AbortController();
  const status = h('p', { class: 'status', role: 'status' });
  const rows = h('tbody');
  const more = button('Older jobs', () => {
    view.pages += 1;
    void attempt(Promise.resolve());
  }, { hidden: true });
  const view = { state: '', pages: 1, loads: 0, jobs: [] as SimJob[] };
  const drawn = new Map<string, { text: string; element: HTMLElement }>();  // by job
  const nothing = h('tr', {}, h('td', { colspan: 6 }, 'No jobs here yet.'));

  const attempt = async (what: Promise<unknown>): Promise<void> => {
    try {
      await what;
      status.textContent = '';
      await load();
    } catch (error) {
      status.textContent = error instanceof ApiError ? error.message : String(error);
    }
  };

  const row = (job: SimJob): HTMLElement => {
    const id = jobId(job);
    const name = job.scene_name || id;
    const action = hasEnded(job.state)
      ? button('Delete', () => void (window.confirm(`Delete ${name} and its ${job.study ? 'report' : 'frames'}?`) && attempt(deleteSimJob(id))), { 'aria-label': `Delete ${name}` })
      : button('Cancel', () => void attempt(cancelSimJob(id)), { 'aria-label': `Cancel ${name}`, disabled: job.cancel_requested });
    return h('tr', {},
      h('th', { scope: 'row' }, h('a', { href: `#/jobs/${id}` }, name), h('span', { class: 'job-id' }, id)),
      h('td', {}, h('span', { class: `state state-${(job.state ?? '').toLowerCase()}` }, stateText(job))),
      h('td', {}, workText(job)), h('td', {}, progressText(job)), h('td', {}, timeElement(job.create_time)), h('td', { class: 'actions' }, action));
  };

  /// The row of a job, drawn anew only when that changed.
  const rowOf = (job: SimJob): HTMLElement => {
    const text = JSON.stringify(job);
    const kept = drawn.get(jobId(job));
    if (kept?.text === text) return kept.element;
    const element = row(job);
    drawn.set(jobId(job), { text, element });
    return element;
  };

  /// Whoever was at a link or button in a row stays at it, or comes to the row in its place.
  const draw = (): void => {
    const at = document.activeElement;
    const place = [...rows.children].findIndex((element) => element.contains(at));
    const id = [...drawn].find(([, { element }]) => element.contains(at))?.[0];
    const wanted = view.jobs.length > 0 ? view.jobs.map(rowOf) : [nothing];
    for (const element of [...rows.children]) if (!wanted.includes(element as HTMLElement)) element.remove();
    wanted.forEach((element, index) => {
      if (rows.children[index] !== element) rows.insertBefore(element, rows.children[index] ?? null);
    });
    for (const [key, { element }] of drawn) if (!element.isConnected && rows.isConnected) drawn.delete(key);
    if (place < 0 || rows.contains(document.activeElement)) return;
    const home = (id && drawn.get(id)?.element) || wanted[Math.min(place, wanted.length - 1)];
    const controls = [home.querySelector<HTMLElement>(`${at?.tagName}:not(:disabled)`), home.querySelector<HTMLElement>('a'), filter.querySelector('select')];
    controls.find((control) => control)?.focus();
  };

  /// All pages shown, from the newest job on. Of loads that overlap the one that began last counts.
  async function load(): Promise<void> {
    view.loads += 1;
    const mine = view.loads;
    const jobs = new Map<string, SimJob>();
    let token = '';
    for (let page = 0; page < view.pages; ++page) {
      const answer = await listSimJobs(token, view.state);
      if (mine !== view.loads) return;
      for (const job of answer.jobs ?? []) jobs.set(jobId(job), job);
      token = answer.next_page_token ?? '';
      if (token === '') break;
    }
    const old = view.jobs.length;
    view.jobs = [...jobs.values()];
    const leaves = token === '' && document.activeElement === more;
    more.hidden = token === '';
    draw();
    if (leaves) rows.children[Math.min(old, view.jobs.length - 1)]?.querySelector('a')?.focus();
  }

  void askWhileSeen(async () => {
    try {
      await load();
      if (status.textContent?.startsWith('the server cannot')) status.textContent = '';
    } catch (error) {
      status.textContent = error instanceof Error ? error.message : String(error);
    }
    return false;
  }, () => refreshMs, stop.signal);

  const filter = select('Show', states, '', (state) => {
    Object.assign(view, { state, pages: 1 });
    void attempt(Promise.resolve());
  });
  const table = h('table', { class: 'jobs' },
    h('thead', {}, h('tr', {}, ...['Scene', 'State', 'Work', 'Progress', 'Made', 'Action'].map((text) => h('th', { scope: 'col' }, text)))), rows);
  const element = h('div', { class: 'page' },
    h('div', { class: 'page-head' }, h('h1', {}, 'Jobs'), filter, h('a', { class: 'button', href: '#/new' }, 'New job')),
    status, h('div', { class: 'table-frame' }, table), more);
  return { title: 'Jobs', element, leave: () => stop.abort() };
}
