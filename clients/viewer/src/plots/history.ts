// SPDX-License-Identifier: MIT
// history.csv: one row a frame; counters count from the start of the run; an empty cell was not measured.

export interface History {
  columns: readonly string[];
  /// By column, NaN where not measured.
  values: ReadonlyMap<string, readonly number[]>;
  rows: number;
}

/// The file may still be written: a last line without its end is left out.
export function parseHistory(text: string): History {
  const complete = text.slice(0, text.lastIndexOf('\n') + 1);
  const [head = '', ...lines] = complete.split('\n').map((line) => line.replace(/\r$/, '')).filter((line) => line !== '' && !line.startsWith('#'));
  const columns = head === '' ? [] : head.split(',');
  const cells = lines.map((line) => line.split(',')).filter((row) => row.length === columns.length);
  const values = new Map(columns.map((column, index) => [column, cells.map((row) => (row[index] === '' ? NaN : Number(row[index])))]));
  return { columns, values, rows: cells.length };
}

export interface Series {
  name: string;
  term: string;  // of the energy, as in its column; empty for other values
  y: readonly number[];
}

export interface PlotData {
  title: string;
  unit: string;
  x: readonly number[];  // simulated time in s
  series: readonly Series[];
  logarithmic: boolean;
}

function column(history: History, name: string): readonly number[] {
  return history.values.get(name) ?? [];
}

function differences(values: readonly number[]): number[] {
  return values.map((value, index) => (index === 0 ? value : value - values[index - 1]));
}

function changes(values: readonly number[]): number[] {
  const first = values.find((value) => !Number.isNaN(value)) ?? 0;
  return values.map((value) => value - first);
}

function measured(values: readonly number[]): boolean {
  return values.some((value) => !Number.isNaN(value));
}

/// The plots of a run; those without a measured value are left out. `sinceStart`: energies less those of the first frame.
export function plotsOf(history: History, sinceStart = false): PlotData[] {
  const x = column(history, 't_s');
  const energies = history.columns
    .filter((name) => name.endsWith('_j') && column(history, name).some((value) => value !== 0 && !Number.isNaN(value)))
    .map((name) => ({ name: name.slice(0, -2).replaceAll('_', ' '), term: name.slice(0, -2), y: sinceStart ? changes(column(history, name)) : column(history, name) }));
  const single = (title: string, unit: string, y: readonly number[], logarithmic: boolean): PlotData =>
    ({ title, unit, x, series: [{ name: title, term: '', y }], logarithmic });
  const plots: PlotData[] = [
    { title: sinceStart ? 'Energy by effect, change since the start' : 'Energy by effect', unit: 'J', x, series: energies, logarithmic: false },
    single('Step size', 's', column(history, 'step_s'), true),
    single('Newton iterations a frame', '', differences(column(history, 'newton_iterations')), false),
    single('Error estimate', 'm', column(history, 'error_estimate_m'), true),
  ];
  return plots.filter((plot) => plot.series.some((series) => measured(series.y)));
}
