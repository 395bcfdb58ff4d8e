// SPDX-License-Identifier: MIT
// What is to be done with the scene, beside Submit.
import type { FieldError } from '../api/field_errors';
import type { SimJob } from '../api/messages';
import type { Order, Work } from '../api/sim_jobs';
import { freshId, h, select } from '../ui/dom';

const orderKey = 'slipstitch.order';
const works: readonly [Work, string][] = [['simulate', 'simulate'], ['study', 'study accuracy'], ['quick study', 'quick study']];

export interface OrderFields {
  elements: readonly HTMLElement[];
  order(): Order;
  /// What is typed and is no number.
  problems(): FieldError[];
  show(order: Order): void;
}

export function orderOf(job: SimJob): Order {
  const { study, threads } = job;
  return { work: study ? (study.quick ? 'quick study' : 'study') : 'simulate', budget_s: study?.budget_s || undefined, threads };
}

function storedOrder(): Order {
  try {
    const order = JSON.parse(sessionStorage.getItem(orderKey) ?? '{}') as Partial<Order>;
    return { ...order, work: works.find(([work]) => work === order.work)?.[0] ?? 'simulate' };
  } catch {
    return { work: 'simulate' };
  }
}

/// Survives a reload of the page, with the scene.
function keep(order: Order): void {
  try {
    sessionStorage.setItem(orderKey, JSON.stringify(order));
  } catch {
    // Storage is forbidden: then it does not.
  }
}

function numberField(label: string, least: number, step: string, hint: string, changed: () => void): { element: HTMLElement; input: HTMLInputElement } {
  const input = h('input', { type: 'number', id: freshId('order'), min: least, step, title: hint, placeholder: hint });
  input.addEventListener('change', changed);
  return { input, element: h('span', { class: 'labelled order-field' }, h('label', { for: input.id }, label), input) };
}

export function orderFields(): OrderFields {
  const state = storedOrder();
  const changed = (): void => {
    budget.element.hidden = state.work === 'simulate';
    Object.assign(state, { budget_s: numberOf(budget.input), threads: numberOf(threads.input) });
    keep(order());
  };
  const numberOf = (input: HTMLInputElement): number | undefined => (input.value === '' ? undefined : Number(input.value));
  const work = select('Work', works, state.work, (chosen) => {
    state.work = chosen as Work;
    changed();
  });
  const budget = numberField('Budget in s', 0, 'any', 'none', changed);
  const threads = numberField('Threads', 1, '1', 'usual', changed);
  const order = (): Order => ({ work: state.work, budget_s: state.work === 'simulate' ? undefined : state.budget_s, threads: state.threads });
  const show = (shown: Order): void => {
    state.work = shown.work;
    const box = work.querySelector('select');
    if (box) box.value = shown.work;
    budget.input.value = shown.budget_s === undefined ? '' : String(shown.budget_s);
    threads.input.value = shown.threads === undefined ? '' : String(shown.threads);
    changed();
  };
  show({ ...state });
  const problems = (): FieldError[] => [budget, threads]
    .filter(({ element, input }) => !element.hidden && !input.validity.valid)
    .map(({ element, input }) => ({ path: '', message: `${element.querySelector('label')?.textContent}: ${input.validationMessage}` }));
  return { elements: [work, budget.element, threads.element], order, problems, show };
}
