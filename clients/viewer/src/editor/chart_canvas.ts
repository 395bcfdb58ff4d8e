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

export function drawChart(canvas: HTMLCanvasElement, look: ChartLook, layout: ChartLayout): void {
  const { chart, cursor, rows, focused } = look;
  const { cell, left } = layout;
  const ratio = window.devicePixelRatio || 1;
  canvas.width = Math.round(layout.width * ratio);
  canvas.height = Math.round(layout.height * ratio);
  canvas.style.width = `${layout.width}px`;
  canvas.style.height = `${layout.height}px`;
  const context = canvas.getContext('2d');
  if (!context) return;
  const style = getComputedStyle(canvas);
  const colour = (name: string): string => style.getPropertyValue(name).trim();
  context.scale(ratio, ratio);
  context.fillStyle = colour('--chart-knit');
  context.fillRect(left, margin.top, cell * width(chart), cell * chart.length);
  context.fillStyle = colour('--chart-chosen');
  context.fillRect(left - 3, margin.top + rows[0] * cell, cell * width(chart) + 6, (rows[1] - rows[0] + 1) * cell);
  chart.forEach((letters, row) => [...letters].forEach((letter, column) => {
    if (letter !== 'P') return;
    context.fillStyle = colour('--chart-purl');
    context.fillRect(left + column * cell, margin.top + row * cell, cell, cell);
    context.fillStyle = colour('--chart-ink');
    context.beginPath();
    context.arc(left + (column + 0.5) * cell, margin.top + (row + 0.5) * cell, Math.max(1.2, cell * 0.17), 0, 2 * Math.PI);
    context.fill();
  }));
  context.strokeStyle = colour('--chart-line');
  context.lineWidth = 1;
  context.beginPath();
  for (let row = 0; row <= chart.length; ++row) {
    context.moveTo(left, margin.top + row * cell + 0.5);
    context.lineTo(left + cell * width(chart), margin.top + row * cell + 0.5);
  }
  for (let column = 0; column <= width(chart); ++column) {
    context.moveTo(left + column * cell + 0.5, margin.top);
    context.lineTo(left + column * cell + 0.5, margin.top + cell * chart.length);
  }
  context.stroke();
  drawNumbers(context, look, layout, colour('--ink-soft'));
  context.strokeStyle = focused ? colour('--accent') : colour('--ink-soft');
  context.lineWidth = focused ? 3 : 1.5;
  context.strokeRect(left + cursor.column * cell + 1, margin.top + cursor.row * cell + 1, cell - 1, cell - 1);
}
