// SPDX-License-Identifier: MIT
// The server speaks in SI units; at a field its errors are in the unit that the field is typed in.
import { fieldAt, type NumberField, type VectorField } from './field';
import { keysOf } from './json_path';
import { numberText } from './number_text';
import { sceneField } from './scene_fields';

const decimal = '-?\\d+(?:\\.\\d+)?(?:e[-+]?\\d+)?';
const refusal = new RegExp(`^is (${decimal}), expected (.*)$`, 's');
const bound = new RegExp(`^((?:a finite number|three numbers) >=?) (${decimal})$`);

function scaledField(path: string): NumberField | VectorField | undefined {
  const keys = keysOf(path);
  const last = keys[keys.length - 1];
  const field = fieldAt(sceneField, keys) ?? (typeof last === 'number' ? fieldAt(sceneField, keys.slice(0, -1)) : undefined);
  return (field?.kind === 'number' || field?.kind === 'vector') && field.scale !== 1 ? field : undefined;
}

/// What is wrong with the value at a path, in the unit of its field; where the expectation is more than a bound, it stays
/// as it is and the value is given in both.
export function inFieldUnit(path: string, message: string): string {
  const found = refusal.exec(message);
  const field = found ? scaledField(path) : undefined;
  if (!found || !field) return message;
  const text = (number: string): string => `${numberText(Number(number) / field.scale)} ${field.unit}`;
  const [, value, expected] = found;
  const limit = bound.exec(expected);
  return limit ? `is ${text(value)}, expected ${limit[1]} ${text(limit[2])}` : `is ${value} (${text(value)}), expected ${expected}`;
}
