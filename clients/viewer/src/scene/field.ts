// SPDX-License-Identifier: MIT
// How a message of the schema is shown: one description from which forms, default values and error places are made.

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };
export type JsonObject = { [key: string]: Json };

export type Field =
  | NumberField
  | { kind: 'text'; label: string; hint: string }
  | { kind: 'flag'; label: string; default: boolean; hint: string }
  | { kind: 'choice'; label: string; options: readonly string[]; hint: string }
  | VectorField
  | { kind: 'numbers'; label: string; hint: string }
  | ListField
  | GroupField;

/// Shown in `unit`, which is `scale` of the schema's SI unit.
export interface NumberField {
  kind: 'number';
  label: string;
  unit: string;
  scale: number;
  whole: boolean;
  /// In the schema's unit, or words where the server works it out.
  default: string;
}

export interface VectorField {
  kind: 'vector';
  label: string;
  unit: string;
  scale: number;
  default: readonly [number, number, number];
}

export interface ListField {
  kind: 'list';
  label: string;
  item: Field;
  itemName: string;
  fresh: Json;
}

/// A message. Of the fields named in one entry of `oneOf` at most one is present.
export interface GroupField {
  kind: 'group';
  label: string;
  fields: Readonly<Record<string, Field>>;
  oneOf: readonly OneOf[];
}

export interface OneOf {
  label: string;
  keys: readonly string[];
  /// What stands where none of the keys does; absent: one must be chosen.
  none?: string;
}

interface Unit {
  unit?: string;
  scale?: number;
}

export function number(label: string, fallback: number | string, { unit = '', scale = 1 }: Unit = {}): NumberField {
  return { kind: 'number', label, unit, scale, whole: false, default: String(fallback) };
}

export function whole(label: string, fallback: number | string): NumberField {
  return { kind: 'number', label, unit: '', scale: 1, whole: true, default: String(fallback) };
}

export function vector(label: string, fallback: readonly [number, number, number], { unit = '', scale = 1 }: Unit = {}): VectorField {
  return { kind: 'vector', label, unit, scale, default: fallback };
}

export function text(label: string, hint = ''): Field {
  return { kind: 'text', label, hint };
}

export function flag(label: string, fallback = false, hint = ''): Field {
  return { kind: 'flag', label, default: fallback, hint };
}

export function choice(label: string, options: readonly string[], hint = ''): Field {
  return { kind: 'choice', label, options, hint };
}

export function numbers(label: string, hint: string): Field {
  return { kind: 'numbers', label, hint };
}

export function list(label: string, itemName: string, item: Field, fresh: Json): ListField {
  return { kind: 'list', label, item, itemName, fresh };
}

export function group(label: string, fields: Record<string, Field>, ...oneOf: OneOf[]): GroupField {
  return { kind: 'group', label, fields, oneOf };
}

/// What is described at a place within a field, by names and indices; undefined where there is nothing.
export function fieldAt(field: Field, keys: readonly (string | number)[]): Field | undefined {
  let at: Field | undefined = field;
  for (const key of keys) {
    if (typeof key === 'number') at = at?.kind === 'list' ? at.item : undefined;
    else at = at?.kind === 'group' && Object.hasOwn(at.fields, key) ? at.fields[key] : undefined;
  }
  return at;
}

export const mm = { unit: 'mm', scale: 1e-3 };
export const seconds = { unit: 's', scale: 1 };
