// SPDX-License-Identifier: MIT
// What a run of the scene would take, asked of the server once nothing has changed for a while.
import type { Prediction } from '../api/messages';
import { createSimJob } from '../api/sim_jobs';
import { h } from '../ui/dom';
import { sleep, whileSeen } from '../ui/presence';
import { estimateText } from './estimate_text';

const quietMs = 1500;  // the server tries the run for as long as half a second
const longestText = 64 * 1024;  // more than that takes one of the server's few places for uploads

export interface Estimate {
  element: HTMLElement;
  /// The scene, or what is to be done with it, is another.
  changed(): void;
  /// An answer comes by other means, unless there is another change before it: then it is left.
  expect(): (prediction: Prediction | undefined) => void;
  leave(): void;
}

/// `simulated`: the text of the scene, where there is one that could be simulated.
export function estimate(simulated: () => string | undefined): Estimate {
  const state = { asking: new AbortController() };
  const line = h('span', {});
  const again = h('span', {});
  const body = h('div', {});
  const element = h('details', { class: 'estimate unknown' }, h('summary', {}, line, again), body);
  /// What is shown is about the scene before the last change.
  const setOld = (old: boolean): void => {
    element.ariaBusy = String(old);
    again.textContent = old ? ' · estimating anew …' : '';
  };
  /// What is not known leaves its place empty, so that nothing moves.
  const show = (prediction: Prediction | undefined): void => {
    setOld(false);
    element.classList.toggle('unknown', prediction === undefined);
    if (!prediction) return;
    const { fails, choice, times, basis, ...text } = estimateText(prediction);
    line.textContent = text.line;
    const notes = [choice, basis].filter((note) => note !== '').map((note) => h('p', { class: 'note' }, note));
    body.replaceChildren(...(fails ? [h('p', { class: 'problem' }, `A run ends at its start: ${fails}`)] : []),
      h('dl', { class: 'numbers' }, ...times.flatMap(([of, time]) => [h('dt', {}, of), h('dd', {}, time)])), ...notes);
  };
  const begin = (): AbortSignal => {
    state.asking.abort();
    state.asking = new AbortController();
    return state.asking.signal;
  };
  async function ask(signal: AbortSignal): Promise<void> {
    await sleep(quietMs, signal);
    (await whileSeen(signal)).abort();
    const text = signal.aborted ? undefined : simulated();
    const answer = text === undefined || text.length > longestText ? undefined
      : await createSimJob(text, { validateOnly: true, signal }).catch(() => undefined);  // Check says why
    if (!signal.aborted) show(answer?.prediction);
  }
  return {
    element,
    changed: () => {
      setOld(true);
      void ask(begin());
    },
    expect: () => {
      const signal = begin();
      return (prediction) => {
        if (!signal.aborted) show(prediction);
      };
    },
    leave: () => state.asking.abort(),
  };
}
