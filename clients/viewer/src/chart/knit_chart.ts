// SPDX-License-Identifier: MIT
import type { Json, JsonObject } from '../scene/field';
import { isObject, join } from '../scene/json_path';
import { largestChart, swapStitches, type Chart } from './chart';
import { presetChart, presetNames } from './presets';

const mirrored = (row: string): string => [...row].reverse().join('');

/// As knitted, from row 1: flat, a row is worked from the right, and even ones on the wrong side, where knit is purl.
function chartOfWorkedRows(rows: readonly string[], inTheRound: boolean): Chart {
  const seen = rows.map((row, index) => (inTheRound || index % 2 === 0 ? mirrored(row) : swapStitches([row])[0]));
  return seen.reverse();
}

function unlike(path: string, value: Json | undefined, expected: string): string {
  const text = value === undefined ? 'missing' : JSON.stringify(value);
  return `${path} is ${text.length > 60 ? `${text.slice(0, 60)} …` : text}, expected ${expected}`;
}

/// The rows of a chart or of worked rows, in capitals; a string in answer says what is wrong with them.
function rowsAt(path: string, message: Json | undefined): string[] | string {
  if (!isObject(message)) return unlike(path, message, 'an object');
  const given = message.rows ?? [];
  if (!Array.isArray(given)) return unlike(`${path}.rows`, given, 'rows of K and P');
  if (given.length === 0) return `${path} has no rows`;
  const rows: string[] = [];
  for (const [index, row] of given.entries()) {
    const here = join(`${path}.rows`, index);
    if (typeof row !== 'string') return unlike(here, row, 'a row of K and P');
    const wrong = /[^KPkp]/.exec(row);
    if (wrong) return `${here} has ${wrong[0]} at stitch ${wrong.index + 1}, expected K or P`;
    if (row === '') return `${here} has no stitch`;
    rows.push(row.toUpperCase());
    if (row.length !== rows[0].length) return `${here} has ${row.length} stitches, expected ${rows[0].length} as in the first row`;
  }
  return rows;
}

function chartOfPreset(path: string, preset: Json | undefined): Chart | string {
  if (!isObject(preset)) return unlike(path, preset, 'an object');
  const { name, courses, wales, rib_knits: ribKnits = 1, rib_purls: ribPurls = 1 } = preset as Partial<JsonObject>;
  if (typeof name !== 'string') return unlike(`${path}.name`, name, 'a name');
  if (!presetNames.includes(name)) return unlike(`${path}.name`, name, `${presetNames.slice(0, -1).join(', ')} or ${presetNames[presetNames.length - 1]}`);
  const fits = (count: Json | undefined, most: number): count is number => Number.isInteger(count) && Number(count) >= 1 && Number(count) <= most;
  const [size, some] = [`a whole number from 1 to ${largestChart}`, 'a whole number > 0'];
  if (!fits(courses, largestChart)) return unlike(`${path}.courses`, courses, size);
  if (!fits(wales, largestChart)) return unlike(`${path}.wales`, wales, size);
  if (!fits(ribKnits, Infinity)) return unlike(`${path}.rib_knits`, ribKnits, some);
  if (!fits(ribPurls, Infinity)) return unlike(`${path}.rib_purls`, ribPurls, some);
  return presetChart({ name, courses, wales, ribKnits, ribPurls });
}

/// The stitches of a scene's member `knit`, of whatever type, in whatever way it gives them; a string in answer says why
/// they cannot be drawn.
export function chartOfKnit(knit: Json | undefined): Chart | string {
  if (knit === undefined) return 'there is no knit';
  if (!isObject(knit)) return unlike('knit', knit, 'an object');
  if (knit.chart !== undefined) return rowsAt('knit.chart', knit.chart);
  if (knit.worked_rows !== undefined) {
    const rows = rowsAt('knit.worked_rows', knit.worked_rows);
    return typeof rows === 'string' ? rows : chartOfWorkedRows(rows, knit.in_the_round === true);
  }
  return knit.preset === undefined ? 'knit has no chart, preset or worked_rows' : chartOfPreset('knit.preset', knit.preset);
}
