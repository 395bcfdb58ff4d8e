// SPDX-License-Identifier: MIT
// What a run is expected to take, in words.
import type { PredictedRun, Prediction } from '../api/messages';
import { roughTime, shortNumber } from '../scene/number_text';

export interface EstimateText {
  line: string;
  fails: string;  // how a run ends at its start; empty: it does not
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

/// What the time of a run rests on; empty where the server does not say.
function basisOf({ basis, until_s: until = 0, basis_tolerance_m: tolerance = 0 }: PredictedRun): string {
  const to = tolerance > 0 ? `, run to ${millimetres(tolerance)}` : '';
  switch (basis) {
    case 'WHOLE_RUN': return `the whole run, made by the server to know${to}`;
    case 'FIRST_MOMENTS': return `the first ${shortNumber(until)} s, tried by the server${to}`;
    case 'CANNED_RUN': return 'a run of a small swatch, as a step of this scene takes too long to try';
    default: return '';
  }
}

function basisText({ as_it_is: asItIs, to_tolerance: [first] = [] }: Prediction): string {
  const [own, others] = [asItIs, first].map((run) => run && basisOf(run));
  const parts = own && own === others ? [`All times rest on ${own}.`]
    : [own && `The time of the scene as it is rests on ${own}.`, others && `Times to a tolerance rest on ${others}.`];
  const known = asItIs || first;
  return [...parts, known ? 'On the server’s machine, with one thread; most are within a factor of two.'
    : 'How long it takes is not known before it is run.'].filter(Boolean).join(' ');
}

export function estimateText(prediction: Prediction): EstimateText {
  const { unknowns = 0, memory_bytes: memory = '0', as_it_is: asItIs, to_tolerance: others = [], run_fails: fails = '' } = prediction;
  const parts = [`${counts.format(unknowns)} ${unknowns === 1 ? 'unknown' : 'unknowns'}`, `about ${sizeText(Number(memory))}`];
  if (fails) parts.push('fails at its start');
  else if (asItIs) parts.push(timeText(asItIs));
  const times = [...(asItIs && !fails ? [['As it is', stepsText(asItIs)] as const] : []),
    ...others.map((run) => [`To ${millimetres(run.tolerance_m ?? 0)}`, stepsText(run)] as const)];
  return { line: parts.join(' · '), fails, times, basis: basisText(fails ? { ...prediction, as_it_is: undefined } : prediction) };
}
