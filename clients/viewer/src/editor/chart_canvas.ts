// SPDX-License-Identifier: MIT
// The picture of a chart: squares as knitters write them, seen from the right side. Only draws and tells places.
import { courseOfRow, width, type Cell, type Chart } from '../chart/chart';

export interface ChartLook {
  chart: Chart;
  cursor: Cell;
  rows: readonly [number, number];  // chosen, from the top
  inTheRound: boolean;
  focused: boolean;
}

const margin = { side: 30, bottom: 20, top: 2 };

/// Where a cell begins in the picture, in px.
export function placeOfCell({ cell, left }: ChartLayout, { row, column }: Cell): { x: number; y: number } {
  return { x: left + column * cell, y: margin.top + row * cell };
}

export interface ChartLayout {
  cell: number;  // px
  left: number;
  width: number;
  height: number;
}

export function layoutOf(chart: Chart, available: number): ChartLayout {
  const columns = Math.max(width(chart), 1);
  const cell = Math.max(5, Math.min(26, Math.floor((available - 2 * margin.side) / columns)));
  return { cell, left: margin.side, width: 2 * margin.side + cell * columns, height: margin.top + cell * chart.length + margin.bottom };
}

/// The cell at a place of the picture in px; `inside` false: beside the squares, e.g. on a row's number.
export function cellAt(chart: Chart, layout: ChartLayout, x: number, y: number): { cell: Cell; inside: boolean } {
  const column = Math.floor((x - layout.left) / layout.cell);
  const row = Math.floor((y - margin.top) / layout.cell);
  const inside = column >= 0 && column < width(chart) && row >= 0 && row < chart.length;
  return { cell: { row: Math.min(Math.max(row, 0), chart.length - 1), column: Math.min(Math.max(column, 0), width(chart) - 1) }, inside };
}

/// A number every so many, so that they do not run into each other.
function every(cell: number): number {
  return cell >= 15 ? 1 : cell >= 8 ? 2 : 5;
}

function drawNumbers(context: CanvasRenderingContext2D, look: ChartLook, layout: ChartLayout, ink: string): void {
  const { chart, inTheRound } = look;
  const { cell, left } = layout;
  context.fillStyle = ink;
  context.font = `${Math.min(12, Math.max(9, cell - 4))}px system-ui, sans-serif`;
  context.textBaseline = 'middle';
  for (let row = 0; row < chart.length; ++row) {
    const course = courseOfRow(chart, row);
    if (course !== 1 && course % every(cell) !== 0) continue;
    const y = margin.top + (row + 0.5) * cell;
    // Worked from the right: odd courses begin at the right, even ones of flat pieces at the left.
    const right = inTheRound || course % 2 === 1;
    context.textAlign = right ? 'left' : 'right';
    context.fillText(String(course), right ? left + width(chart) * cell + 5 : left - 5, y);
  }
  context.textAlign = 'center';
  const step = every(cell / 1.6);
  for (let column = 0; column < width(chart); ++column) {
    if (column !== 0 && (column + 1) % step !== 0) continue;
    context.fillText(String(column + 1), left + (column + 0.5) * cell, margin.top + chart.length * cell + 11);
  }
}

const colourNames = ['--chart-knit', '--chart-chosen', '--chart-purl', '--chart-ink', '--chart-line', '--ink-soft', '--accent'] as const;
type Colours = Record<(typeof colourNames)[number], string>;

function coloursOf(canvas: HTMLCanvasElement): Colours {
  const style = getComputedStyle(canvas);
  return Object.fromEntries(colourNames.map((name) => [name, style.getPropertyValue(name).trim()])) as Colours;
}

/// All that a drawn chart depends on.
export interface DrawnChart {
  look: ChartLook;
  layout: ChartLayout;
  ratio: number;  // device pixels a px
  colours: Colours;
}

/// First and last row, from the top.
type Band = readonly [number, number];

function drawSquares(context: CanvasRenderingContext2D, { look, layout, colours }: DrawnChart, [first, last]: Band): void {
  const { chart, rows } = look;
  const { cell, left } = layout;
  const [columns, top] = [width(chart), margin.top + first * cell];
  context.fillStyle = colours['--chart-knit'];
  context.fillRect(left, top, cell * columns, (last - first + 1) * cell);
  const chosen = [Math.max(rows[0], first), Math.min(rows[1], last)];
  context.fillStyle = colours['--chart-chosen'];
  if (chosen[0] <= chosen[1]) context.fillRect(left - 3, margin.top + chosen[0] * cell, cell * columns + 6, (chosen[1] - chosen[0] + 1) * cell);
  const radius = Math.max(1.2, cell * 0.17);
  for (let row = first; row <= last; ++row) {
    const y = margin.top + row * cell;
    // A path a row: one for each square costs seconds on a large chart.
    const [squares, dots] = [new Path2D(), new Path2D()];
    for (const { index, 0: purls } of chart[row].matchAll(/P+/g)) {
      squares.rect(left + index * cell, y, purls.length * cell, cell);
      for (let column = index; column < index + purls.length; ++column) {
        const [x, centre] = [left + (column + 0.5) * cell, y + 0.5 * cell];
        dots.moveTo(x + radius, centre);
        dots.arc(x, centre, radius, 0, 2 * Math.PI);
      }
    }
    context.fillStyle = colours['--chart-purl'];
    context.fill(squares);
    context.fillStyle = colours['--chart-ink'];
    context.fill(dots);
  }
}

/// On whole device pixels: as sharp as they can be, and the same whatever is drawn around them.
function drawLines(context: CanvasRenderingContext2D, { look, layout, ratio, colours }: DrawnChart, [first, last]: Band): void {
  const { cell, left } = layout;
  const columns = width(look.chart);
  const snapped = (value: number): number => Math.round(value * ratio) / ratio;
  const thickness = Math.max(1, Math.round(ratio)) / ratio;
  const [top, bottom] = [snapped(margin.top + first * cell), snapped(margin.top + (last + 1) * cell)];
  context.fillStyle = colours['--chart-line'];
  const end = snapped(left + columns * cell);
  for (let row = first; row <= last + 1; ++row) context.fillRect(snapped(left), snapped(margin.top + row * cell), end - snapped(left), thickness);
  for (let column = 0; column <= columns; ++column) context.fillRect(snapped(left + column * cell), top, thickness, bottom - top);
}

function drawCursor(context: CanvasRenderingContext2D, { look, layout, colours }: DrawnChart): void {
  const { cursor, focused } = look;
  const { cell, left } = layout;
  context.strokeStyle = focused ? colours['--accent'] : colours['--ink-soft'];
  context.lineWidth = focused ? 3 : 1.5;
  context.strokeRect(left + cursor.column * cell + 1, margin.top + cursor.row * cell + 1, cell - 1, cell - 1);
}

/// The part of the picture that rows own, on whole device pixels, with what the cursor and chosen rows draw beside them.
function clipTo(context: CanvasRenderingContext2D, { look, layout, ratio }: DrawnChart, [first, last]: Band): void {
  const { cell, left } = layout;
  const top = first === 0 ? 0 : margin.top + first * cell;
  const bottom = margin.top + (last + 1) * cell + (last === look.chart.length - 1 ? 4 : 0);
  const [x, y] = [Math.floor((left - 3) * ratio) / ratio, Math.floor(top * ratio) / ratio];
  const [right, end] = [Math.ceil((left + cell * width(look.chart) + 4) * ratio) / ratio, Math.ceil(bottom * ratio) / ratio];
  context.beginPath();
  context.rect(x, y, right - x, end - y);
  context.clip();
  context.clearRect(x, y, right - x, end - y);
}

/// Runs of rows that are not as they were drawn; the cursor's line reaches into the rows beside it.
function changedBands({ look }: DrawnChart, { look: before }: DrawnChart): Band[] {
  const chosen = ({ rows }: ChartLook, row: number): boolean => row >= rows[0] && row <= rows[1];
  const moved = look.cursor.row !== before.cursor.row || look.cursor.column !== before.cursor.column || look.focused !== before.focused;
  const nearCursor = (row: number): boolean => Math.min(Math.abs(row - look.cursor.row), Math.abs(row - before.cursor.row)) <= 1;
  const bands: [number, number][] = [];
  for (let row = 0; row < look.chart.length; ++row) {
    if (look.chart[row] === before.chart[row] && chosen(look, row) === chosen(before, row) && !(moved && nearCursor(row))) continue;
    if (bands.length > 0 && bands[bands.length - 1][1] === row - 1) bands[bands.length - 1][1] = row;
    else bands.push([row, row]);
  }
  return bands;
}

function isOtherPicture(now: DrawnChart, before: DrawnChart): boolean {
  const frame = ({ look, layout, ratio, colours }: DrawnChart): string =>
    JSON.stringify([look.chart.length, width(look.chart), look.inTheRound, layout, ratio, colours]);
  return frame(now) !== frame(before);
}

function drawAll(canvas: HTMLCanvasElement, context: CanvasRenderingContext2D, now: DrawnChart): void {
  const { look, layout, ratio, colours } = now;
  canvas.width = Math.round(layout.width * ratio);
  canvas.height = Math.round(layout.height * ratio);
  canvas.style.width = `${layout.width}px`;
  canvas.style.height = `${layout.height}px`;
  context.scale(ratio, ratio);
  const all: Band = [0, look.chart.length - 1];
  drawSquares(context, now, all);
  drawLines(context, now, all);
  drawNumbers(context, look, layout, colours['--ink-soft']);
  drawCursor(context, now);
}

/// `before`: what the canvas shows; only rows that differ from it are drawn. The answer is what it shows now.
export function drawChart(canvas: HTMLCanvasElement, look: ChartLook, layout: ChartLayout, before: DrawnChart | undefined): DrawnChart {
  const now: DrawnChart = { look, layout, ratio: window.devicePixelRatio || 1, colours: coloursOf(canvas) };
  const context = canvas.getContext('2d', { willReadFrequently: true });  // in main memory: paths of many squares take a GPU seconds
  if (!context) return now;
  if (!before || isOtherPicture(now, before)) {
    drawAll(canvas, context, now);
    return now;
  }
  for (const band of changedBands(now, before)) {
    context.save();
    clipTo(context, now, band);
    const around: Band = [Math.max(band[0] - 1, 0), Math.min(band[1] + 1, look.chart.length - 1)];
    drawSquares(context, now, around);
    drawLines(context, now, around);
    drawCursor(context, now);
    context.restore();
  }
  return now;
}
