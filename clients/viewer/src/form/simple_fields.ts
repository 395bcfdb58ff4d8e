// SPDX-License-Identifier: MIT
// Inputs of single values.
import type { Field, Json, NumberField, VectorField } from '../scene/field';
import { valueAt } from '../scene/json_path';
import { numberText, parseNumber, parseNumbers, parseWhole } from '../scene/number_text';
import { h, type Child } from '../ui/dom';
import { fieldId, type FormContext } from './form_context';

/// A row of label, input and the place for errors. Errors are filled in from outside, by data-path.
export function fieldRow(path: string, label: Child, input: HTMLElement, unit = ''): HTMLElement {
  const errorId = `${fieldId(path)}-error`;
  for (const control of [input, ...input.querySelectorAll('input, select, textarea')]) {
    if (/^(INPUT|SELECT|TEXTAREA)$/.test(control.tagName)) control.setAttribute('aria-describedby', errorId);
  }
  return h('div', { class: 'field', 'data-path': path },
    h('label', { for: fieldId(path) }, label, unit && h('span', { class: 'unit' }, ` ${unit}`)), input,
    h('p', { class: 'field-error', id: errorId, hidden: true }));
}

function shownNumber(value: Json | undefined, scale: number): string {
  if (typeof value === 'number') return numberText(value / scale);
  return value === undefined ? '' : typeof value === 'string' ? value : JSON.stringify(value);
}

function placeholder(field: NumberField): string {
  const value = Number(field.default);
  return Number.isFinite(value) ? numberText(value / field.scale) : field.default;
}

export function numberInput(context: FormContext, field: NumberField, path: string): HTMLElement {
  const input = h('input', { id: fieldId(path), type: 'text', inputmode: field.whole ? 'numeric' : 'decimal', autocomplete: 'off',
    value: shownNumber(valueAt(context.scene(), path), field.scale), placeholder: placeholder(field),
    'aria-required': field.default === 'required' && 'true' });
  input.addEventListener('change', () => {
    try {
      context.set(path, field.whole ? parseWhole(input.value) : parseNumber(input.value, field.scale), false);
      context.complain(path, undefined);
    } catch (error) {
      context.complain(path, (error as Error).message);
    }
  });
  return fieldRow(path, field.label, input, field.unit);
}

export function vectorInput(context: FormContext, field: VectorField, path: string): HTMLElement {
  const present = valueAt(context.scene(), path);
  const items = Array.isArray(present) ? present : [];
  const inputs = ['x', 'y', 'z'].map((axis, index) => h('input', {
    id: index === 0 ? fieldId(path) : undefined, type: 'text', inputmode: 'decimal', autocomplete: 'off', 'aria-label': `${field.label}, ${axis}`,
    value: shownNumber(items[index], field.scale), placeholder: numberText(field.default[index] / field.scale),
  }));
  const read = (): void => {
    try {
      const values = inputs.map((input) => parseNumber(input.value, field.scale));
      const isEmpty = values.every((value) => value === undefined);
      context.set(path, isEmpty ? undefined : values.map((value, index) => value ?? field.default[index]), false);
      context.complain(path, undefined);
    } catch (error) {
      context.complain(path, (error as Error).message);
    }
  };
  for (const input of inputs) input.addEventListener('change', read);
  return fieldRow(path, field.label, h('span', { class: 'vector' }, ...inputs), field.unit);
}

/// A long array of numbers, as text.
export function numbersInput(context: FormContext, label: string, hint: string, path: string): HTMLElement {
  const present = valueAt(context.scene(), path);
  const area = h('textarea', { id: fieldId(path), rows: 4, spellcheck: 'false', placeholder: hint });
  area.value = Array.isArray(present) ? present.map((value) => shownNumber(value, 1)).join(' ') : '';
  area.addEventListener('change', () => {
    try {
      const values = parseNumbers(area.value);
      context.set(path, values.length === 0 ? undefined : values, false);
      context.complain(path, undefined);
    } catch (error) {
      context.complain(path, (error as Error).message);
    }
  });
  return fieldRow(path, label, area);
}

export function textInput(context: FormContext, label: string, hint: string, path: string): HTMLElement {
  const present = valueAt(context.scene(), path);
  const input = h('input', { id: fieldId(path), type: 'text', autocomplete: 'off', placeholder: hint, value: typeof present === 'string' ? present : '' });
  input.addEventListener('change', () => context.set(path, input.value === '' ? undefined : input.value, false));
  return fieldRow(path, label, input);
}

export function flagInput(context: FormContext, field: Extract<Field, { kind: 'flag' }>, path: string): HTMLElement {
  const present = valueAt(context.scene(), path) ?? field.default;
  const input = h('input', { id: fieldId(path), type: 'checkbox', checked: present === true });
  input.addEventListener('change', () => context.set(path, input.checked === field.default ? undefined : input.checked, false));
  const row = fieldRow(path, field.label, input);
  row.classList.add('flag');
  if (field.hint) row.querySelector('label')?.append(h('span', { class: 'unit' }, ` (${field.hint})`));
  return row;
}

export function choiceInput(context: FormContext, label: string, options: readonly string[], path: string): HTMLElement {
  const present = valueAt(context.scene(), path);
  const input = h('select', { id: fieldId(path) }, ...options.map((option) =>
    h('option', { value: option, selected: option === present }, option.toLowerCase().replaceAll('_', ' '))));
  input.addEventListener('change', () => context.set(path, input.value, false));
  return fieldRow(path, label, input);
}
