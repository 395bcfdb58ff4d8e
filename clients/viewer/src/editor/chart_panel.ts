// SPDX-License-Identifier: MIT
// The chart with its tools: size, fabrics with a name, repeat, rows, text.
import { chartFromText, largestChart, repeat, repeatProblem, resize, sizeProblem, swapStitches, width, type Chart } from '../chart/chart';
import { chartOfKnit } from '../chart/knit_chart';
import { presetChart, presetMenu } from '../chart/presets';
import { fieldId } from '../form/form_context';
import type { Json, JsonObject } from '../scene/field';
import { isObject } from '../scene/json_path';
import { button, h } from '../ui/dom';
import { chartEditor } from './chart_editor';
import { chartLegend } from './chart_legend';

export interface ChartPanel {
  element: HTMLElement;
  /// The places of what was typed here, for complain.
  typed: readonly string[];
  show(scene: JsonObject): void;
  leave(): void;
}

export interface ChartSink {
  /// The new member `knit` of the scene.
  changed(knit: Json | undefined): void;
  undo(): void;
  /// What was typed at a place is no value (message) or is one again (undefined).
  complain(place: string, message: string | undefined): void;
}

const problemId = 'chart-size-problem';

function sizeInput(label: string, value: number): HTMLInputElement {
  return h('input', { type: 'number', min: 1, max: largestChart, value, 'aria-label': label, 'aria-describedby': problemId });
}

function problemOf(input: HTMLInputElement, problem: (typed: string) => string | undefined): string | undefined {
  return input.validity.badInput ? 'is no number' : problem(input.value);
}

/// Where an error of what was typed as a size belongs.
function sizePlace(input: HTMLInputElement): HTMLElement {
  return h('span', { class: 'size', 'data-path': input.ariaLabel as string }, input);
}

/// What of a knit says which stitches there are.
function patternOf(knit: JsonObject): (Json | undefined)[] {
  return [knit.chart, knit.preset, knit.worked_rows, knit.in_the_round];
}

function freshRows(): string[] {
  return Array.from({ length: 10 }, () => 'K'.repeat(10));
}

export function chartPanel({ changed, undo, complain }: ChartSink): ChartPanel {
  const state = { knit: undefined as JsonObject | undefined, chart: [] as Chart };
  const told = new Map<string, string | undefined>();
  const give = (chart: Chart): void => {
    const knit = { ...state.knit };
    delete knit.preset;
    delete knit.worked_rows;
    changed({ ...knit, chart: { rows: [...chart] } });
  };
  const editor = chartEditor(give, undo);
  const [courses, wales] = [sizeInput('Courses', 10), sizeInput('Wales', 10)];
  const [times, across] = [sizeInput('Times upwards', 2), sizeInput('Times sideways', 2)];
  const problem = h('p', { class: 'problem', role: 'alert', id: problemId, hidden: true });
  /// Says what is wrong with numbers, at them; true: nothing is.
  const right = (found: [HTMLInputElement, string | undefined][]): boolean => {
    for (const input of [courses, wales]) {
      const [place, why] = [input.ariaLabel as string, found.find(([at]) => at === input)?.[1]];
      if (told.get(place) !== why) complain(place, why);
      told.set(place, why);
    }
    for (const input of [courses, wales, times, across]) input.removeAttribute('aria-invalid');
    const wrong = found.filter(([, why]) => why !== undefined);
    for (const [input] of wrong) input.setAttribute('aria-invalid', 'true');
    problem.textContent = wrong.map(([input, why]) => `${input.ariaLabel} ${why}.`).join(' ');
    problem.hidden = wrong.length === 0;
    return wrong.length === 0;
  };
  const resized = (): void => {
    if (right([[courses, problemOf(courses, sizeProblem)], [wales, problemOf(wales, sizeProblem)]]))
      give(resize(state.chart, Number(courses.value), Number(wales.value)));
  };
  const showSize = (): void => {
    courses.value = String(state.chart.length);
    wales.value = String(width(state.chart));
  };
  const repeated = (): void => {
    showSize();
    if (right([[times, problemOf(times, (typed) => repeatProblem(typed, state.chart.length))],
      [across, problemOf(across, (typed) => repeatProblem(typed, width(state.chart)))]]))
      give(repeat(state.chart, Number(times.value), Number(across.value)));
  };
  courses.addEventListener('change', resized);
  wales.addEventListener('change', resized);
  const fabrics = h('select', { 'aria-label': 'Fill with a fabric' }, h('option', { value: '' }, 'Fill with …'),
    ...presetMenu.map((preset, index) => h('option', { value: index }, preset.label)));
  fabrics.addEventListener('change', () => {
    if (fabrics.value === '') return;
    give(presetChart({ ...presetMenu[Number(fabrics.value)], courses: state.chart.length, wales: width(state.chart) }));
    fabrics.value = '';
  });
  const text = h('textarea', { rows: 6, spellcheck: 'false', 'aria-label': 'Chart as rows of K and P' });
  const textError = h('p', { class: 'field-error', role: 'alert', hidden: true });
  const readText = (): void => {
    const chart = chartFromText(text.value);
    textError.hidden = typeof chart !== 'string';
    textError.textContent = typeof chart === 'string' ? `The text ${chart}.` : '';
    if (typeof chart !== 'string') give(chart);
  };
  const asText = h('details', { class: 'parameters' }, h('summary', {}, 'Chart as text'), text, textError, button('Use this text', readText, { class: 'small' }));
  const source = h('p', { class: 'note' });
  const tools = h('div', { class: 'chart-tools' },
    h('span', { class: 'pair' }, 'Courses', sizePlace(courses), '× wales', sizePlace(wales)), fabrics,
    h('span', { class: 'pair' }, button('Copy rows', () => editor.copy(), { class: 'small' }), button('Paste rows', () => editor.paste(), { class: 'small' })),
    h('span', { class: 'pair' }, button('Repeat', repeated, { class: 'small' }),
      times, '× up,', across, '× across'),
    h('span', { class: 'pair' }, button('Swap knit and purl', () => give(swapStitches(state.chart)), { class: 'small' }), button('Undo', undo, { class: 'small' })));
  const drawn = h('div', {}, tools, problem, editor.element, chartLegend());
  const unreadable = h('p', { hidden: true, role: 'status' });
  const anew = button('Begin a new chart', () => give(freshRows()), { hidden: true });
  const body = h('div', { class: 'chart-body' }, drawn, unreadable, anew, source, asText);
  const none = h('div', { hidden: true }, h('p', {}, 'This scene has no knit.'), button('Add a knit', () => changed(
    { chart: { rows: freshRows() }, gauge: { course_spacing_m: 0.0029, wale_spacing_m: 0.00203 } })));

  const show = (scene: JsonObject): void => {
    const knit = isObject(scene.knit) ? scene.knit : undefined;
    none.hidden = knit !== undefined;
    body.hidden = knit === undefined;
    const before = state.knit && patternOf(state.knit);
    state.knit = knit;
    if (!knit) return void right([]);
    if (before && patternOf(knit).every((part, index) => part === before[index])) return;  // what was typed as a size stays
    const chart = chartOfKnit(knit);
    const readable = typeof chart !== 'string';
    drawn.hidden = !readable;
    unreadable.hidden = anew.hidden = readable;
    unreadable.textContent = readable ? '' : `The stitches cannot be shown: ${chart}.`;
    source.textContent = !readable ? ''
      : knit.preset !== undefined ? 'The scene names this fabric; drawing replaces the name by a chart.'
        : knit.worked_rows !== undefined ? 'The scene gives rows as worked; drawing replaces them by a chart.' : '';
    state.chart = readable ? chart : [];
    right([]);
    showSize();
    if (document.activeElement !== text) text.value = state.chart.join('\n');
    if (readable) editor.show(state.chart, knit.in_the_round === true);
  };
  const element = h('div', { 'data-path': 'knit', id: fieldId('knit'), tabindex: -1 }, h('p', { class: 'field-error', hidden: true }),
    h('div', { 'data-path': 'knit.chart' }, h('p', { class: 'field-error', hidden: true }), body), none);
  return { element, show, typed: [courses.ariaLabel as string, wales.ariaLabel as string], leave: () => editor.leave() };
}
