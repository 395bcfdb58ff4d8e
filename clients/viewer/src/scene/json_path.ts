// SPDX-License-Identifier: MIT
// Places in a JSON value, spelled as the server spells them: "handles[0].where.corner".
import type { Json, JsonObject } from './field';

type Key = string | number;

export function keysOf(path: string): Key[] {
  return [...path.matchAll(/[^.[\]]+|\[(\d+)\]/g)].map((match) => (match[1] === undefined ? match[0] : Number(match[1])));
}

export function join(path: string, key: Key): string {
  if (typeof key === 'number') return `${path}[${key}]`;
  return path === '' ? key : `${path}.${key}`;
}

export function isObject(value: Json | undefined): value is JsonObject {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

export function valueAt(root: Json, path: string): Json | undefined {
  let value: Json | undefined = root;
  for (const key of keysOf(path)) {
    if (typeof key === 'number') value = Array.isArray(value) ? value[key] : undefined;
    else value = isObject(value) && Object.hasOwn(value, key) ? value[key] : undefined;
  }
  return value;
}

function replaced(value: Json | undefined, keys: Key[], wanted: Json | undefined): Json | undefined {
  if (keys.length === 0) return wanted;
  const [key, ...rest] = keys;
  if (typeof key === 'number') {
    const items = Array.isArray(value) ? [...value] : [];
    const item = replaced(items[key], rest, wanted);
    if (item === undefined) items.splice(key, 1);
    else items[key] = item;
    return items;
  }
  const members: JsonObject = isObject(value) ? { ...value } : {};
  const member = replaced(Object.hasOwn(members, key) ? members[key] : undefined, rest, wanted);
  if (member === undefined) delete members[key];
  else members[key] = member;
  return members;
}

/// A copy with `wanted` at `path`, its parents made as needed; undefined removes it.
export function withValue(root: JsonObject, path: string, wanted: Json | undefined): JsonObject {
  return replaced(root, keysOf(path), wanted) as JsonObject;
}

/// Whether two values say the same; the order of members does not count.
export function isSame(one: Json, other: Json): boolean {
  if (Array.isArray(one)) return Array.isArray(other) && one.length === other.length && one.every((item, index) => isSame(item, other[index]));
  if (!isObject(one) || !isObject(other)) return one === other;
  const keys = Object.keys(one);
  return keys.length === Object.keys(other).length && keys.every((key) => Object.hasOwn(other, key) && isSame(one[key], other[key]));
}
