// SPDX-License-Identifier: MIT
import { effectEntries, type EffectEntry } from '../scene/effect_fields';
import { group } from '../scene/field';
import { isObject, join, valueAt } from '../scene/json_path';
import { h } from '../ui/dom';
import { groupFields } from './field_form';
import { fieldId, type FormContext } from './form_context';

function labelOf(name: string): string {
  return effectEntries.find((entry) => entry.name === name)?.label ?? name;
}

function switchOf(context: FormContext, entry: EffectEntry): HTMLElement {
  const path = join('effects', entry.name);
  const present = valueAt(context.scene(), path);
  const on = isObject(present);
  const input = h('input', { type: 'checkbox', role: 'switch', id: fieldId(path), checked: on, 'aria-describedby': `${fieldId(path)}-about ${fieldId(path)}-error` });
  input.addEventListener('change', () => context.set(path, input.checked ? entry.fresh : undefined, true));
  const lacking = entry.needs !== undefined && valueAt(context.scene(), join('effects', entry.needs)) === undefined;
  const needs = entry.needs !== undefined && h('span', { class: lacking && on ? 'needs lacking' : 'needs' }, ` Needs ${labelOf(entry.needs).toLowerCase()}.`);
  const form = on && Object.keys(entry.fields).length > 0
    && h('details', { class: 'parameters', open: entry.name === 'colliders' || entry.name === 'wind' || entry.name === 'shrinkage' },
      h('summary', {}, 'Parameters', h('span', { class: 'visually-hidden' }, ` of ${entry.label}`)), ...groupFields(context, group('', { ...entry.fields }), path));
  return h('div', { class: on ? 'effect on' : 'effect', 'data-path': path },
    h('div', { class: 'effect-head' }, input, h('label', { for: input.id }, entry.label)),
    h('p', { class: 'about', id: `${fieldId(path)}-about` }, entry.about, needs),
    h('p', { class: 'field-error', id: `${fieldId(path)}-error`, hidden: true }), form);
}

/// One switch an effect, with its parameters where it is on.
export function effectSwitches(context: FormContext): HTMLElement {
  return h('div', { class: 'effects', 'data-path': 'effects', id: fieldId('effects'), tabindex: -1 },
    h('p', { class: 'field-error', id: `${fieldId('effects')}-error`, hidden: true }), ...effectEntries.map((entry) => switchOf(context, entry)));
}
