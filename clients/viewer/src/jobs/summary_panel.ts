// SPDX-License-Identifier: MIT
import { shortNumber } from '../scene/number_text';
import { h } from '../ui/dom';
import type { JobModel } from './job_model';
import { spanText } from './job_text';
import { timeShares, timeSharesView } from './time_shares';

interface Summary {
  loops?: number;
  nodes?: number | null;  // null: there was no fabric, and nothing of it is known
  dofs?: number;
  effects?: string[];
  steps?: number;
  rejected_steps?: number;
  newton_iterations?: number;
  wall_s?: number;
  wall_by_phase_s?: Record<string, number> | null;  // null: of a study
  max_stretch?: number | null;
  error_estimate_m?: number | null;
  predictable_until_s?: number | null;
  budget?: BudgetSummary | null;
  linear_solver?: string;
  threads?: number;
  study?: StudySummary | null;
}

interface BudgetSummary {
  budget_s: number;
  kept: boolean;
  same_tolerance_m: number | null;
  loosest_tolerance_m: number;
}

interface StudySummary {
  rungs?: { wall_s?: number }[];
  reference?: { error_m?: number | null };
  digit_factor?: number | null;
}

function studyRows({ rungs = [], reference, digit_factor: factor }: StudySummary): [string, string | undefined][] {
  const error = reference?.error_m;
  return [
    ['Ways to run it', String(rungs.filter((rung) => rung.wall_s !== undefined).length)],
    ['Reference is off by', typeof error === 'number' ? `about ${shortNumber(1e3 * error)} mm` : undefined],
    ['One more digit costs', typeof factor === 'number' ? `×${shortNumber(factor)} the time` : undefined],
  ];
}

function errorText({ error_estimate_m: error, predictable_until_s: until }: Summary): string | undefined {
  if (typeof error !== 'number') return undefined;
  const estimate = `about ${shortNumber(1e3 * error)} mm at most`;
  return typeof until === 'number' ? `${estimate}; not predictable beyond ${shortNumber(until)} s` : estimate;
}

function budgetText({ budget_s: asked, kept, same_tolerance_m: same, loosest_tolerance_m: loosest }: BudgetSummary): string {
  const used = typeof same === 'number' ? `${spanText(asked)}, as a tolerance of about ${shortNumber(1e3 * same)} mm takes` : spanText(asked);
  return kept ? used : `${used}; not kept: it goes no looser than to ${shortNumber(1e3 * loosest)} mm`;
}

function rowsOf(summary: Summary): [string, string][] {
  const rows: [string, string | undefined][] = [
    ['Loops', summary.loops?.toString()],
    ['Nodes', summary.nodes?.toString()],
    ['Unknowns', summary.dofs?.toString()],
    ...(summary.study ? studyRows(summary.study) : []),
    ['Steps', typeof summary.steps !== 'number' || summary.nodes === null ? undefined : `${summary.steps}, ${summary.rejected_steps ?? 0} rejected`],
    ['Newton iterations', summary.nodes === null ? undefined : summary.newton_iterations?.toString()],
    ['Wall time', typeof summary.wall_s !== 'number' ? undefined : spanText(summary.wall_s)],
    ['Budget', summary.budget ? budgetText(summary.budget) : undefined],
    ['Error of positions', errorText(summary)],
    ['Yarn stretched to', typeof summary.max_stretch === 'number' ? `${shortNumber(100 * summary.max_stretch)} % at most` : undefined],
    ['Effects', summary.effects?.join(', ').replaceAll('_', ' ')],
    ['Solver', summary.linear_solver ?? undefined],
    ['Threads', summary.threads?.toString()],
  ];
  return rows.filter((row): row is [string, string] => row[1] !== undefined);
}

/// Where the time of the run goes, and what it cost once it has ended. Last on the page: it grows, and nothing may move for it.
export function summaryPanel(model: JobModel): HTMLElement {
  const numbers = h('dl', { class: 'numbers' });
  const shares = timeSharesView();
  const element = h('section', { class: 'panel', 'aria-label': 'Run', hidden: true }, h('h2', {}, 'Run'), numbers, shares.element);
  model.job.subscribe((job) => {
    if (!job?.summary_json) {
      const { wall_by_phase_s: byPhase, wall_s: wall } = job?.progress ?? {};
      const found = timeShares(byPhase, wall);
      if (found.length === 0) return;
      element.hidden = false;
      return shares.show(found, 'Time goes to');
    }
    element.hidden = false;
    const summary = JSON.parse(job.summary_json) as Summary;
    shares.show(timeShares(summary.wall_by_phase_s, summary.wall_s), 'Time went to');
    numbers.replaceChildren(...rowsOf(summary).flatMap(([name, value]) => [h('dt', {}, name), h('dd', {}, value)]));
  });
  return element;
}
