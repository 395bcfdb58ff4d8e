// SPDX-License-Identifier: MIT
// JSON read as the server reads it: nothing in the text is lost without a word. JSON.parse takes the last of two members
// with one name, and rounds integers beyond 2^53.
import type { Json } from './field';
import { join } from './json_path';

interface Reader {
  text: string;
  at: number;
  /// The value of an integer that no double holds.
  bigInteger(digits: string, path: string): Json;
}

const token = /\s*("(?:[^"\\]|\\.)*"|[{}[\],:]|[^\s{}[\],:"]+)/y;

function next(reader: Reader): string {
  token.lastIndex = reader.at;
  const found = token.exec(reader.text);
  if (!found) throw new Error('the text ends too early');
  reader.at = token.lastIndex;
  return found[1];
}

function peek(reader: Reader): string {
  const { at } = reader;
  const found = next(reader);
  reader.at = at;
  return found;
}

/// Of what ends at `reader.at`, from 1.
function place(reader: Reader, length: number): string {
  const before = reader.text.slice(0, reader.at - length).split('\n');
  return `line ${before.length}, column ${before[before.length - 1].length + 1}`;
}

function readObject(reader: Reader, path: string): Json {
  const members = new Map<string, Json>();
  while (peek(reader) !== '}') {
    const word = next(reader);
    const key = JSON.parse(word) as string;
    const here = join(path, key);
    if (members.has(key)) throw new Error(`${here} stands there twice, the second time in ${place(reader, word.length)}; expected each key once in an object`);
    next(reader);  // :
    members.set(key, readValue(reader, here));
    if (peek(reader) === ',') next(reader);
  }
  next(reader);
  return Object.fromEntries(members);
}

function readArray(reader: Reader, path: string): Json {
  const items: Json[] = [];
  while (peek(reader) !== ']') {
    items.push(readValue(reader, join(path, items.length)));
    if (peek(reader) === ',') next(reader);
  }
  next(reader);
  return items;
}

function readNumber(reader: Reader, word: string, path: string): Json {
  const value = Number(word);
  if (!Number.isFinite(value)) throw new Error(`${path} is ${word} in ${place(reader, word.length)}, expected a number below 1.8e308`);
  if (Number.isSafeInteger(value) || !/^-?\d+$/.test(word) || BigInt(word) === BigInt(value)) return value;
  return reader.bigInteger(word, path);
}

function readValue(reader: Reader, path: string): Json {
  const word = next(reader);
  if (word === '{') return readObject(reader, path);
  if (word === '[') return readArray(reader, path);
  return /^[-\d]/.test(word) ? readNumber(reader, word, path) : (JSON.parse(word) as Json);
}

/// Throws an Error that says what is wrong, and where.
export function parseStrictly(text: string, bigInteger: Reader['bigInteger']): Json {
  JSON.parse(text);  // its grammar: what follows only looks for what this forgives
  return readValue({ text, at: 0, bigInteger }, '');
}
