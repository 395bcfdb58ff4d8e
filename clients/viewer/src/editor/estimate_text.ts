// SPDX-License-Identifier: MIT
// What a run is expected to take, in words.
import type { PredictedRun, Prediction } from '../api/messages';
import { roughTime, shortNumber } from '../scene/number_text';

export interface EstimateText {
  line: string;
  fails: string;  // how a run ends at its start; empty: it does not
  choice: string;  // of effects, before the run; empty: there is none
  times: readonly (readonly [string, string])[];  // of what, how long
  basis: string;
}

const counts = new Intl.NumberFormat('en');

function sizeText(bytes: number): string {
  return bytes < 1e9 ? `${Number((bytes / 1e6).toPrecision(2))} MB` : `${Number((bytes / 1e9).toPrecision(2))} GB`;
}

function millimetres(metres: number): string {
  return `${shortNumber(1e3 * metres)} mm`;
}

function timeText({ wall_s: wall = 0 }: PredictedRun): string {
  return wall < 0.1 ? 'less than 0.1 s' : `about ${roughTime(wall)}`;
}

function stepsText(run: PredictedRun): string {
  const steps = Number(run.steps ?? 0);
  return steps === 0 ? timeText(run) : `${timeText(run)}, ${counts.format(steps)} ${steps === 1 ? 'step' : 'steps'}`;
}

/// What the time of a run rests on; empty where the server does not say. `untried`: why the scene was not tried.
function basisOf({ basis, until_s: until = 0, basis_tolerance_m: tolerance = 0 }: PredictedRun, untried: string): string {
  const to = tolerance > 0 ? `, run to ${millimetres(tolerance)}` : '';
  switch (basis) {
    case 'WHOLE_RUN': return `the whole run, made by the server to know${to}`;
    case 'FIRST_MOMENTS': return `the first ${shortNumber(until)} s, tried by the server${to}`;
    case 'CANNED_RUN': return `how a small swatch runs on the server${untried}`;
    default: return '';
  }
}

/// `fails`: of the scene as it is nothing is known but that.
function basisText(asItIs: PredictedRun | undefined, first: PredictedRun | undefined, fails: boolean): string {
  const untried = ', as there was no time to try this scene';
  const own = asItIs && basisOf(asItIs, untried);
  const others = first && basisOf(first, fails ? '' : asItIs?.basis === 'CANNED_RUN' ? untried : `${untried} to a tolerance`);
  const parts = own && own === others ? [`All times rest on ${own}.`]
    : [own && `The time of the scene as it is rests on ${own}.`, others && `Times to a tolerance rest on ${others}.`];
  const known = asItIs || first;
  return [...parts, known ? 'On the server’s machine, with one thread; most are within a factor of two.'
    : !fails && 'How long it takes is not known before it is run.'].filter(Boolean).join(' ');
}

const choiceText = 'The run begins with a choice of effects: it tries the scene’s beginning with and without effects, which can take longer '
  + 'than the run. No time here includes it.';

export function estimateText(prediction: Prediction): EstimateText {
  const { unknowns = 0, memory_bytes: memory = '0', to_tolerance: others = [], run_fails: fails = '', chooses_effects: chooses = false } = prediction;
  const parts = [`${counts.format(unknowns)} ${unknowns === 1 ? 'unknown' : 'unknowns'}`, `about ${sizeText(Number(memory))}`];
  const asItIs = fails ? undefined : prediction.as_it_is;
  if (fails) parts.push('fails at its start');
  else if (asItIs) parts.push(`${timeText(asItIs)}${chooses ? ' and the choice of effects before it' : ''}`);
  else if (chooses) parts.push('the choice of effects before it');
  const times = [...(asItIs ? [['As it is', stepsText(asItIs)] as const] : []),
    ...others.map((run) => [`To ${millimetres(run.tolerance_m ?? 0)}`, stepsText(run)] as const)];
  return { line: parts.join(' · '), fails, choice: chooses ? choiceText : '', times, basis: basisText(asItIs, others[0], fails !== '') };
}
