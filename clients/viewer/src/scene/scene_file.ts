// SPDX-License-Identifier: MIT
import { fieldAt, type Json, type JsonObject } from './field';
import { isObject, keysOf } from './json_path';
import { sceneField } from './scene_fields';
import { parseStrictly } from './strict_json';

/// What a new scene starts from: a swatch that hangs on its upper corners.
export function freshScene(): JsonObject {
  return {
    name: 'my-swatch',
    knit: {
      chart: { rows: Array.from({ length: 10 }, () => 'K'.repeat(10)) },
      gauge: { course_spacing_m: 0.0029, wale_spacing_m: 0.00203 },
      placement: { course_direction: [1, 0, 0], wale_direction: [0, 0, -1] },
    },
    effects: {
      inertia: {}, gravity: {}, stretch: {}, bending: {}, bending_jamming: {}, wrapping: { alpha: 0.03 },
      contact_length: {}, parallel_contact: {}, sliding: {}, sliding_friction: {},
      damping: { bending_nm2s: 1.35e-8, wrapping_ns: 9e-3, sliding_ns_per_m: 10 },
    },
    handles: [{ where: { corner: 'TOP_LEFT' } }, { where: { corner: 'TOP_RIGHT' } }],
    duration_s: 0.5,
  };
}

/// Integers of the schema go as text where no double holds them, as in protobuf's JSON; any other number is a double.
function bigInteger(digits: string, path: string): Json {
  const field = fieldAt(sceneField, keysOf(path.replace(/^(spec\.)?scene\./, '')));
  return field?.kind === 'number' && field.whole ? digits : Number(digits);
}

/// Reads the text of a scene file. Throws an Error that says what is wrong with it.
export function readScene(text: string): JsonObject {
  const value = parseStrictly(text, bigInteger);
  if (!isObject(value)) throw new Error('a scene file is one JSON object');
  return value;
}

/// The scene as a file. Arrays of numbers stay on one line.
export function sceneText(scene: JsonObject): string {
  return `${valueText(scene, '')}\n`;
}

function valueText(value: Json, indent: string): string {
  const inner = `${indent}  `;
  const lines = (open: string, parts: string[], close: string): string =>
    parts.length === 0 ? open + close : `${open}\n${inner}${parts.join(`,\n${inner}`)}\n${indent}${close}`;
  if (Array.isArray(value)) {
    if (value.every((item) => typeof item === 'number')) return `[${value.map((item) => JSON.stringify(item)).join(', ')}]`;
    return lines('[', value.map((item) => valueText(item, inner)), ']');
  }
  if (!isObject(value)) return JSON.stringify(value);
  return lines('{', Object.entries(value).map(([key, member]) => `${JSON.stringify(key)}: ${valueText(member, inner)}`), '}');
}
