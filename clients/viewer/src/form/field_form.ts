// SPDX-License-Identifier: MIT
// A form for any field of the schema, made from its description.
import type { Field, GroupField, Json, ListField, OneOf } from '../scene/field';
import { isObject, join, valueAt } from '../scene/json_path';
import { button, h } from '../ui/dom';
import { fieldId, type FormContext } from './form_context';
import { choiceInput, flagInput, numberInput, numbersInput, textInput, vectorInput } from './simple_fields';

export function fieldForm(context: FormContext, field: Field, path: string): HTMLElement {
  switch (field.kind) {
    case 'number': return numberInput(context, field, path);
    case 'vector': return vectorInput(context, field, path);
    case 'numbers': return numbersInput(context, field.label, field.hint, path);
    case 'text': return textInput(context, field.label, field.hint, path);
    case 'flag': return flagInput(context, field, path);
    case 'choice': return choiceInput(context, field.label, field.options, path);
    case 'list': return listForm(context, field, path);
    case 'group': return groupForm(context, field, path);
  }
}

/// What a field has when a person chose it and has typed nothing yet.
export function freshValue(field: Field): Json {
  switch (field.kind) {
    case 'group': return {};
    case 'list': return [];
    case 'choice': return field.options[0];
    case 'flag': return true;
    case 'vector': return [...field.default];
    case 'numbers': return [];
    case 'number': return field.default === 'required' ? '' : 0;
    case 'text': return '';
  }
}

function errorPlace(path: string): HTMLElement {
  return h('p', { class: 'field-error', id: `${fieldId(path)}-error`, hidden: true });
}

/// The fields of a message without a frame around them. `hidden`: names of fields that are shown elsewhere.
export function groupFields(context: FormContext, field: GroupField, path: string, hidden: readonly string[] = []): HTMLElement[] {
  const inChoices = new Set(field.oneOf.flatMap((choice) => choice.keys));
  const plain = Object.entries(field.fields).filter(([name]) => !inChoices.has(name) && !hidden.includes(name));
  return [
    ...field.oneOf.filter((choice) => !choice.keys.some((key) => hidden.includes(key))).map((choice) => oneOfForm(context, field, choice, path)),
    ...plain.map(([name, member]) => fieldForm(context, member, join(path, name))),
  ];
}

function groupForm(context: FormContext, field: GroupField, path: string): HTMLElement {
  return h('fieldset', { class: 'group', 'data-path': path, id: fieldId(path), tabindex: -1 },
    field.label !== '' && h('legend', {}, field.label), errorPlace(path), ...groupFields(context, field, path));
}

/// A select for which of the members is there, and the form of the one that is.
function oneOfForm(context: FormContext, field: GroupField, choice: OneOf, path: string): HTMLElement {
  const message = valueAt(context.scene(), path);
  const chosen = choice.keys.find((key) => isObject(message) && message[key] !== undefined) ?? '';
  const id = fieldId(join(path, `choice_${choice.keys[0]}`));
  const empty = choice.none ?? (chosen === '' ? 'choose …' : undefined);
  const box = h('select', { id }, empty !== undefined && h('option', { value: '', selected: chosen === '' }, empty),
    ...choice.keys.map((key) => h('option', { value: key, selected: key === chosen }, field.fields[key].label)));
  box.addEventListener('change', () => {
    const kept = isObject(message) ? { ...message } : {};
    for (const key of choice.keys) delete kept[key];
    if (box.value !== '') kept[box.value] = freshValue(field.fields[box.value]);
    context.set(path, kept, true);
  });
  const row = h('div', { class: 'field' }, h('label', { for: id }, choice.label), box);
  const absent = choice.keys.filter((key) => key !== chosen).map((key) => join(path, key)).map((other) =>
    h('div', { 'data-path': other, id: fieldId(other), tabindex: -1 }, errorPlace(other)));
  return h('div', { class: 'one-of' }, row, ...absent, chosen !== '' && chosenForm(context, field.fields[chosen], join(path, chosen)));
}

function chosenForm(context: FormContext, field: Field, path: string): HTMLElement {
  if (field.kind !== 'group') return fieldForm(context, field, path);
  return h('div', { class: 'chosen', 'data-path': path, id: fieldId(path), tabindex: -1 }, errorPlace(path), ...groupFields(context, field, path));
}

function listForm(context: FormContext, field: ListField, path: string): HTMLElement {
  const present = valueAt(context.scene(), path);
  const items = Array.isArray(present) ? present : [];
  const removeItem = (index: number): void => {
    const rest = items.filter((_, other) => other !== index);
    context.set(path, rest.length === 0 ? undefined : rest, true);
  };
  const itemForm = (index: number): HTMLElement => {
    const name = `${field.itemName} ${index + 1}`;
    const itemPath = join(path, index);
    const fields = field.item.kind === 'group' ? groupFields(context, field.item, itemPath) : [fieldForm(context, field.item, itemPath)];
    return h('fieldset', { class: 'item', 'data-path': itemPath, id: fieldId(itemPath), tabindex: -1 }, h('legend', {}, name),
      errorPlace(itemPath), ...fields, button(`Remove ${name}`, () => removeItem(index), { class: 'small', 'data-focus': `${fieldId(itemPath)}-remove` }));
  };
  const add = button(`Add ${field.itemName}`, () => context.set(path, [...items, field.fresh], true),
    { class: 'small', 'data-focus': `${fieldId(path)}-add` });
  return h('div', { class: 'list', 'data-path': path, id: fieldId(path), tabindex: -1 },
    h('p', { class: 'list-head' }, `${field.label}${items.length === 0 ? ': none' : ''}`), errorPlace(path), ...items.map((_, index) => itemForm(index)), add);
}
