// SPDX-License-Identifier: MIT
// What is to be done with the scene, beside Submit.
import { orderLabels, type FieldError } from '../api/field_errors';
import type { SimJob } from '../api/messages';
import type { Order, Work } from '../api/sim_jobs';
import { fieldId } from '../form/form_context';
import { numberText, parseNumber, parseWhole } from '../scene/number_text';
import { h } from '../ui/dom';

const orderKey = 'slipstitch.order';
const works: readonly [Work, string][] = [['simulate', 'simulate'], ['study', 'study accuracy'], ['quick study', 'quick study']];

export interface OrderFields {
  elements: readonly HTMLElement[];
  order(): Order;
  /// What is typed and cannot be ordered.
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

const mostThreads = 1024;

/// As typed, within the server's bounds; undefined for an empty field. Throws for other text.
export function parseThreads(typed: string): number | undefined {
  const count = parseWhole(typed);
  if (count === undefined) return undefined;
  if (Number(count) < 0 || Number(count) > mostThreads) throw new Error(`is ${count}, expected 0 to ${mostThreads}`);
  return Number(count);
}

/// Likewise, in s.
export function parseBudget(typed: string): number | undefined {
  const budget = parseNumber(typed, 1);
  if (budget !== undefined && budget < 0) throw new Error(`is ${numberText(budget)}, expected a finite number >= 0`);
  return budget;
}

function orderField(label: string, control: HTMLElement): HTMLElement {
  const [id, errorId] = [fieldId(label), `${fieldId(label)}-error`];
  control.id = id;
  control.setAttribute('aria-describedby', errorId);
  return h('div', { class: 'labelled order-field', 'data-path': label }, h('label', { for: id }, label), control,
    h('p', { class: 'field-error', id: errorId, hidden: true }));
}

interface NumberBox {
  element: HTMLElement;
  /// What is typed, or why that is no value.
  read(): { value?: number; problem?: string };
  show(value: number | undefined): void;
}

function numberBox(label: string, hint: string, inputmode: string, parse: (typed: string) => number | undefined, changed: () => void): NumberBox {
  const input = h('input', { type: 'text', inputmode, autocomplete: 'off', placeholder: hint });
  input.addEventListener('change', changed);
  const read = (): { value?: number; problem?: string } => {
    try {
      return { value: parse(input.value) };
    } catch (error) {
      return { problem: (error as Error).message };
    }
  };
  return { element: orderField(label, input), read, show: (value) => { input.value = value === undefined ? '' : String(value); } };
}

/// `changed` is told the label of a field in which something was typed or chosen.
export function orderFields(changed: (label: string) => void): OrderFields {
  const state = storedOrder();
  const update = (): void => {
    budget.element.hidden = state.work === 'simulate';
    const [typedBudget, typedThreads] = [budget.read(), threads.read()];
    if (!typedBudget.problem) state.budget_s = typedBudget.value;
    if (!typedThreads.problem) state.threads = typedThreads.value;
    keep(order());
  };
  const typed = (label: string) => (): void => {
    update();
    changed(label);
  };
  const work = h('select', {}, ...works.map(([value, text]) => h('option', { value, selected: value === state.work }, text)));
  work.addEventListener('change', () => {
    state.work = work.value as Work;
    typed(orderLabels.work)();
  });
  const budget = numberBox(orderLabels.budget, 'none', 'decimal', parseBudget, typed(orderLabels.budget));
  const threads = numberBox(orderLabels.threads, 'usual', 'numeric', parseThreads, typed(orderLabels.threads));
  const order = (): Order => ({ work: state.work, budget_s: state.work === 'simulate' ? undefined : state.budget_s, threads: state.threads });
  const show = (shown: Order): void => {
    state.work = work.value = shown.work;
    budget.show(shown.budget_s);
    threads.show(shown.threads);
    update();
  };
  show({ ...state });
  const problems = (): FieldError[] => [
    { path: orderLabels.budget, message: budget.element.hidden ? undefined : budget.read().problem },
    { path: orderLabels.threads, message: threads.read().problem },
  ].flatMap(({ path, message }) => (message === undefined ? [] : [{ path, message, about: 'order' as const }]));
  return { elements: [orderField(orderLabels.work, work), budget.element, threads.element], order, problems, show };
}
