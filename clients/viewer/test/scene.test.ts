// SPDX-License-Identifier: MIT
import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { effectEntries } from '../src/scene/effect_fields';
import type { Field } from '../src/scene/field';
import { join, valueAt, withValue } from '../src/scene/json_path';
import { numberText, parseNumber, parseNumbers, parseWhole, shortNumber } from '../src/scene/number_text';
import { inFieldUnit } from '../src/scene/field_unit';
import { freshScene, readScene, sceneText } from '../src/scene/scene_file';
import { sceneField } from '../src/scene/scene_fields';

const schema = new URL('../../../proto/slipstitch/v1/', import.meta.url);

interface ProtoField {
  name: string;
  type: string;
  repeated: boolean;
  comment: string;
}

/// Messages of the schema by name, read as far as a form needs them.
function protoMessages(): Map<string, ProtoField[]> {
  const messages = new Map<string, ProtoField[]>();
  for (const file of ['scene.proto', 'knit.proto', 'effects.proto', 'collider.proto']) {
    let message = '';
    let comment = '';
    for (const line of readFileSync(new URL(file, schema), 'utf8').split('\n')) {
      const start = /^message (\w+)/.exec(line);
      if (start) messages.set((message = start[1]), []);
      if (/^}/.test(line)) message = '';
      const remark = /^\s*\/\/ (.*)$/.exec(line);
      if (remark) comment += ` ${remark[1]}`;
      const field = /^\s+(repeated |optional )?(\w+) (\w+) = \d+;\s*(?:\/\/ (.*))?$/.exec(line);
      if (field && message) messages.get(message)?.push({ type: field[2], name: field[3], repeated: field[1] === 'repeated ', comment: `${comment} ${field[4] ?? ''}` });
      if (!remark) comment = '';
    }
  }
  return messages;
}

function kindOf(field: ProtoField, messages: Map<string, ProtoField[]>): string[] {
  if (messages.has(field.type)) return field.repeated ? ['list'] : ['group'];
  if (field.repeated) return field.type === 'string' ? ['list'] : ['vector', 'numbers'];
  if (field.type === 'string') return ['text'];
  if (field.type === 'bool') return ['flag'];
  return /^(double|int32|uint64)$/.test(field.type) ? ['number'] : ['choice'];
}

/// Paths where the form and the schema differ.
function differences(form: Field, message: string, path: string, messages: Map<string, ProtoField[]>): string[] {
  if (form.kind !== 'group') return [`${path} is ${form.kind}`];
  const known = messages.get(message) ?? [];
  const extra = Object.keys(form.fields).filter((name) => !known.some((field) => field.name === name)).map((name) => `${path}.${name} is not in the schema`);
  return extra.concat(known.flatMap((field) => {
    const here = join(path, field.name);
    const shown = form.fields[field.name];
    if (!shown) return [`${here} is missing`];
    if (!kindOf(field, messages).includes(shown.kind)) return [`${here} is ${shown.kind}`];
    const fallback = /default (-?[\d.]+(?:e-?\d+)?)\b(?!\/)/.exec(field.comment)?.[1];
    if (shown.kind === 'number' && fallback && Number(shown.default) !== Number(fallback)) return [`${here} has default ${shown.default}, not ${fallback}`];
    if (shown.kind === 'number' && shown.whole !== /int/.test(field.type)) return [`${here}: whole numbers`];
    if (shown.kind === 'group') return differences(shown, field.type, here, messages);
    if (shown.kind === 'list' && messages.has(field.type)) return differences(shown.item, field.type, `${here}[0]`, messages);
    return [];
  }));
}

describe('the form', () => {
  const messages = protoMessages();
  it('reads the schema', () => expect(messages.get('YarnMaterial')?.map((field) => field.name)).toContain('bending_nm2'));
  it('has every field of the schema, of its kind and with its default, and no other', () => {
    expect(differences(sceneField, 'Scene', '', messages)).toEqual([]);
  });
  it('knows what every effect needs', () => {
    const text = readFileSync(new URL('effects.proto', schema), 'utf8');
    for (const { name, needs } of effectEntries) {
      const said = new RegExp(`Effects?\\s+${name} = \\d+;\\s*// needs (\\w+)`).exec(text)?.[1];
      expect(needs, name).toBe(said);
    }
  });
});

describe('paths', () => {
  const root = { a: { b: [{ c: 1 }, { c: 2 }] } };
  it('read and write', () => {
    expect(valueAt(root, 'a.b[1].c')).toBe(2);
    expect(valueAt(root, 'a.x[1].c')).toBeUndefined();
    expect(withValue(root, 'a.b[1].c', 3)).toEqual({ a: { b: [{ c: 1 }, { c: 3 }] } });
    expect(withValue(root, 'n.m', 3)).toEqual({ ...root, n: { m: 3 } });
    expect(root.a.b[1].c).toBe(2);
  });
  it('remove', () => {
    expect(withValue(root, 'a.b[0]', undefined)).toEqual({ a: { b: [{ c: 2 }] } });
    expect(withValue(root, 'a', undefined)).toEqual({});
  });
  it('know no inherited members', () => expect(valueAt({}, 'constructor')).toBeUndefined());
});

describe('numbers', () => {
  it('come back as typed, in the unit of the schema', () => {
    expect(parseNumber('0.524', 1e-3)).toBe(0.524e-3);
    expect(numberText(0.524e-3 / 1e-3)).toBe('0.524');
    expect(parseNumber(' 1,5 ', 1)).toBe(1.5);
    expect(parseNumber('', 1)).toBeUndefined();
  });
  it('take a comma for a point where it cannot stand between thousands', () => {
    expect(['0,524', '1,25', '1,0000', '1000,125', '-0,001', '1e3', ' 7 '].map((text) => parseNumber(text, 1))).toEqual([0.524, 1.25, 1, 1000.125, -0.001, 1000, 7]);
  });
  it.each(['x', '1 2', '0x10', 'NaN', '1e999', '--1', '1,000', '-12,500', '+1,000e3', '1,000,000', '1,000.5', '1.000,5', '1 000', '1e', 'Infinity', '1_000'])('%s is none', (text) => expect(() => parseNumber(text, 1)).toThrow(/expected a number/));
  it('say what was typed', () => expect(() => parseNumber(' 1,000 ', 1)).toThrow('is “1,000”, expected a number'));
  it('in a row are parted by spaces or commas', () => {
    expect(parseNumbers(' 0, 0.05,1e3\n-2 0 ')).toEqual([0, 0.05, 1000, -2, 0]);
    expect(parseNumbers('100,200,300')).toEqual([100, 200, 300]);
    expect(parseNumbers(' ')).toEqual([]);
    for (const [text, wrong] of [['1,000', '000'], ['1 x', 'x'], ['2 0x10', '0x10'], ['1;2', '1;2']]) expect(() => parseNumbers(text)).toThrow(`has “${wrong}”, expected numbers`);
  });
  it('are whole where they must be', () => expect(() => parseWhole('1.5')).toThrow(/whole/));
  it('keep every digit of whole numbers', () => {
    expect(['', '42', '18446744073709551615', '-9007199254740993'].map(parseWhole)).toEqual([undefined, 42, '18446744073709551615', '-9007199254740993']);
    expect(() => parseWhole('1e19')).toThrow(/all digits/);
  });
  it('are short for reading', () => expect([0, 1.23456, -0.00012, 123456, NaN].map((value) => shortNumber(value))).toEqual(['0', '1.23', '-1.20e-4', '1.23e5', '–']));
});

describe('errors at fields', () => {
  const radius = 'effects.colliders.colliders[0].sphere.radius_m';
  it.each([
    ['yarn.radius_m', 'is -0.001, expected a finite number > 0', 'is -1 mm, expected a finite number > 0 mm'],
    [radius, 'is 0, expected a finite number > 0', 'is 0 mm, expected a finite number > 0 mm'],
    ['fixed.time_step_s', 'is 1e-07, expected a finite number >= 0.0025', 'is 0.0001 ms, expected a finite number >= 2.5 ms'],
    ['effects.colliders.colliders[1].box.half_size_m', 'is -0.001, expected three numbers > 0', 'is -1 mm, expected three numbers > 0 mm'],
    ['fixed.time_step_s', 'is 0.001, expected at most 0.01 of all', 'is 0.001 (1 ms), expected at most 0.01 of all'],
    ['yarn.radius_m', 'is nan, expected a finite number > 0', 'is nan, expected a finite number > 0'],
    ['yarn.radius_m', 'is “-1x”, expected a number', 'is “-1x”, expected a number'],
    ['yarn.stretch_n', 'is -1, expected a finite number > 0', 'is -1, expected a finite number > 0'],
    ['knit.chart', 'is 3, expected an object', 'is 3, expected an object'],
    ['nowhere', 'is 3, expected nothing', 'is 3, expected nothing'],
  ])('are in their unit: %s %s', (path, said, shown) => expect(inFieldUnit(path, said)).toBe(shown));
});

describe('scene files', () => {
  it('read what they wrote', () => expect(readScene(sceneText(freshScene()))).toEqual(freshScene()));

  it('are laid out like other JSON, but for arrays of numbers', () => {
    const scene = { name: 'a', knit: { chart: { rows: ['KK', 'PP'] }, gauge: {} }, handles: [{ origin_m: [1, -0.5e-9, 3] }], loads: [] };
    const plain = JSON.stringify(scene, null, 2).replace(/\[\s+1,\s+-5e-10,\s+3\s+\]/, '[1, -5e-10, 3]');
    expect(sceneText(scene)).toBe(`${plain}\n`);
  });

  it('leave texts alone and take no longer for odd ones', () => {
    for (const name of ['cape [ 2 ]', 'Fair [ 1,   2 ] isle', `ribbing [ ${'-'.repeat(60)} v2`]) {
      expect(readScene(sceneText({ name })).name).toBe(name);
    }
    const odd = { origin_m: [0.1234567890123456, 0.2345678901234567, null] };
    expect(readScene(sceneText(odd))).toEqual(odd);
  });
  it('keep arrays of numbers on a line', () => expect(sceneText({ v: [0, -9.81, 1e-7] })).toContain('"v": [0, -9.81, 1e-7]'));
  it.each(readdirSync(new URL('../../../scenes/', import.meta.url)).filter((name) => name.endsWith('.json')))('reads %s', (name) => {
    const text = readFileSync(new URL(`../../../scenes/${name}`, import.meta.url), 'utf8');
    expect(JSON.stringify(readScene(sceneText(readScene(text))))).toBe(JSON.stringify(JSON.parse(text)));
  });
  it('lose no key', () => {
    expect(() => readScene('{\n  "name": "a",\n  "name": "a"\n}')).toThrow('name stands there twice, the second time in line 3, column 3');
    expect(() => readScene('{"handles": [{}, {"where": {"edge": "TOP", "e\\u0064ge": "LEFT"}}]}')).toThrow(/^handles\[1\]\.where\.edge stands there twice/);
    expect(Object.keys(readScene('{"__proto__": 1, "b": {"name": 1}, "name": 2}'))).toEqual(['__proto__', 'b', 'name']);
  });
  it('lose no digit of whole numbers', () => {
    const text = '{"knit": {"noise_seed": 18446744073709551615}}';
    expect(valueAt(readScene(text), 'knit.noise_seed')).toBe('18446744073709551615');
    expect(readScene(sceneText(readScene(text)))).toEqual(readScene(text));
    expect(valueAt(readScene(`{"scene": ${text}}`), 'scene.knit.noise_seed')).toBe('18446744073709551615');
    expect(valueAt(readScene('{"knit": {"noise_seed": 9007199254740991}}'), 'knit.noise_seed')).toBe(9007199254740991);
  });
  it('take other numbers as the doubles that they are, and none that is too large', () => {
    expect(readScene('{"yarn": {"stretch_n": 12345678901234567890, "radius_m": 1E-3}}')).toEqual({ yarn: { stretch_n: 12345678901234567890, radius_m: 1e-3 } });
    expect(() => readScene('{"duration_s": 1e999}')).toThrow('duration_s is 1e999 in line 1, column 16');
  });
  it.each(['{"a": 1,}', '{"a" 1}', '[1 2]', '{"a": 01}', '', '{"a": .5}'])('are no other text: %s', (text) => expect(() => readScene(text)).toThrow());
  it('read strings with anything in them', () => expect(readScene('{"name": "a\\"},{[:\\\\", "x": [true, null, []]}')).toEqual({ name: 'a"},{[:\\', x: [true, null, []] }));
  it('refuse what is no object', () => expect(() => readScene('[1]')).toThrow(/one JSON object/));
});
