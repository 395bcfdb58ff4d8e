// SPDX-License-Identifier: MIT
import { largestChart, swapStitches, type Chart } from './chart';
import { presetChart } from './presets';

/// Knit of a scene file, as far as it says which stitches there are.
export interface KnitPattern {
  chart?: { rows?: string[] };
  preset?: { name?: string; courses?: number; wales?: number; rib_knits?: number; rib_purls?: number };
  worked_rows?: { rows?: string[] };
  in_the_round?: boolean;
}

const mirrored = (row: string): string => [...row].reverse().join('');

/// As knitted, from row 1: flat, a row is worked from the right, and even ones on the wrong side, where knit is purl.
function chartOfWorkedRows(rows: readonly string[], inTheRound: boolean): Chart {
  const seen = rows.map((row, index) => {
    const letters = row.toUpperCase();
    if (inTheRound || index % 2 === 0) return mirrored(letters);
    return swapStitches([letters])[0];
  });
  return seen.reverse();
}

/// The stitches as a chart, in whatever way the scene gives them; undefined where it gives none that can be drawn.
export function chartOfKnit(knit: KnitPattern | undefined): Chart | undefined {
  if (!knit) return undefined;
  const drawable = (rows: readonly string[]): boolean =>
    rows.length > 0 && rows[0].length > 0 && rows.every((row) => row.length === rows[0].length && /^[KPkp]*$/.test(row));
  if (knit.chart) {
    const rows = knit.chart.rows ?? [];
    return drawable(rows) ? rows.map((row) => row.toUpperCase()) : undefined;
  }
  if (knit.worked_rows) {
    const rows = knit.worked_rows.rows ?? [];
    return drawable(rows) ? chartOfWorkedRows(rows, knit.in_the_round === true) : undefined;
  }
  const { name = '', courses = 0, wales = 0, rib_knits: ribKnits = 1, rib_purls: ribPurls = 1 } = knit.preset ?? {};
  const fits = (count: number): boolean => Number.isInteger(count) && count >= 1 && count <= largestChart;
  if (!knit.preset || !fits(courses) || !fits(wales)) return undefined;
  return presetChart({ name, courses, wales, ribKnits, ribPurls });
}
