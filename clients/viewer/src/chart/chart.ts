// SPDX-License-Identifier: MIT
// A chart is rows of K and P as in a scene file: what shows on the right side, the last row being course 1. All functions
// give a new chart. Row and column indices count from the top left; course and wale numbers from the bottom left, from 1.

export type Chart = readonly string[];
export type StitchLetter = 'K' | 'P';

export const smallestChart = 2;
export const largestChart = 400;

export interface Cell {
  row: number;
  column: number;
}

export function width(chart: Chart): number {
  return chart[0]?.length ?? 0;
}

export function courseOfRow(chart: Chart, row: number): number {
  return chart.length - row;
}

export function paint(chart: Chart, cell: Cell, letter: StitchLetter): Chart {
  const row = chart[cell.row];
  if (row === undefined || cell.column < 0 || cell.column >= row.length || row[cell.column] === letter) return chart;
  const painted = row.slice(0, cell.column) + letter + row.slice(cell.column + 1);
  return chart.map((old, index) => (index === cell.row ? painted : old));
}

/// Paints the cells on the straight line from one to another, so that a fast pointer leaves no gaps.
export function paintLine(chart: Chart, from: Cell, to: Cell, letter: StitchLetter): Chart {
  const steps = Math.max(Math.abs(to.row - from.row), Math.abs(to.column - from.column), 1);
  let painted = chart;
  for (let step = 0; step <= steps; ++step) {
    const part = step / steps;
    const row = Math.round(from.row + part * (to.row - from.row));
    const column = Math.round(from.column + part * (to.column - from.column));
    painted = paint(painted, { row, column }, letter);
  }
  return painted;
}

/// The number that was typed into a field of whole numbers, NaN where it is none.
function typedNumber(typed: string): number {
  return /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(typed.trim()) ? Number(typed) : NaN;
}

/// What is wrong with a number of courses or wales as typed; undefined: nothing.
export function sizeProblem(typed: string): string | undefined {
  const [count, expected] = [typedNumber(typed), `expected a whole number from ${smallestChart} to ${largestChart}`];
  if (typed.trim() === '') return `is empty, ${expected}`;
  return Number.isInteger(count) && count >= smallestChart && count <= largestChart ? undefined : `is ${typed.trim()}, ${expected}`;
}

/// What is wrong with how often a length of `count` is repeated, as typed; undefined: nothing.
export function repeatProblem(typed: string, count: number): string | undefined {
  const [times, most] = [typedNumber(typed), Math.max(1, Math.floor(largestChart / count))];
  const expected = `expected a whole number from 1 to ${most}, as a chart has at most ${largestChart}`;
  if (typed.trim() === '') return `is empty, ${expected}`;
  return Number.isInteger(times) && times >= 1 && times <= most ? undefined : `is ${typed.trim()}, ${expected}`;
}

/// Keeps course 1 and wale 1 where they are; new stitches are knit.
export function resize(chart: Chart, courses: number, wales: number): Chart {
  const fitted = chart.map((row) => row.slice(0, wales).padEnd(wales, 'K'));
  const kept = fitted.slice(Math.max(0, fitted.length - courses));
  const added = Array.from({ length: courses - kept.length }, () => 'K'.repeat(wales));
  return [...added, ...kept];
}

/// The whole chart again, `times` upwards and `across` sideways.
export function repeat(chart: Chart, times: number, across: number): Chart {
  const rows = chart.map((row) => row.repeat(across));
  return Array.from({ length: times }, () => rows).flat();
}

export function copyRows(chart: Chart, first: number, last: number): Chart {
  return chart.slice(Math.min(first, last), Math.max(first, last) + 1);
}

/// Writes rows over the chart so that the lowest of them lands on `bottomRow`; rows that would stick out at the top are
/// left out. Narrower rows are repeated, wider ones cut.
export function pasteRows(chart: Chart, rows: Chart, bottomRow: number): Chart {
  const columns = width(chart);
  return chart.map((old, row) => {
    const source = rows[rows.length - 1 - (bottomRow - row)];
    return source === undefined || row > bottomRow ? old : source.repeat(Math.ceil(columns / source.length)).slice(0, columns);
  });
}

export function swapStitches(chart: Chart): Chart {
  return chart.map((row) => row.replace(/./g, (letter) => (letter === 'K' ? 'P' : 'K')));
}

/// Reads what a person types: lines of K and P in either case. A string in answer says what is wrong.
export function chartFromText(text: string): Chart | string {
  const rows = text.split(/\r?\n/).map((line) => line.trim().toUpperCase()).filter((line) => line !== '');
  if (rows.length < smallestChart) return `has ${rows.length} rows, expected at least ${smallestChart}`;
  for (const [index, row] of rows.entries()) {
    const wrong = /[^KP]/.exec(row);
    if (wrong) return `has ${wrong[0]} in line ${index + 1}, column ${wrong.index + 1}, expected K or P`;
    if (row.length !== rows[0].length) return `has ${row.length} stitches in line ${index + 1}, expected ${rows[0].length} as in line 1`;
  }
  if (rows[0].length < smallestChart) return `has ${rows[0].length} stitches a row, expected at least ${smallestChart}`;
  if (Math.max(rows.length, rows[0].length) > largestChart) return `is larger than ${largestChart} by ${largestChart}`;
  return rows;
}
