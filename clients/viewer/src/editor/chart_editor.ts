// SPDX-License-Identifier: MIT
import { copyRows, courseOfRow, paint, paintLine, pasteRows, width, type Cell, type Chart, type StitchLetter } from '../chart/chart';
import { h } from '../ui/dom';
import { dark } from '../ui/theme';
import { cellAt, drawChart, layoutOf, placeOfCell, type DrawnChart } from './chart_canvas';

export interface ChartEditor {
  element: HTMLElement;
  canvas: HTMLCanvasElement;
  show(chart: Chart, inTheRound: boolean): void;
  copy(): void;
  paste(): void;
  leave(): void;
}

const moves: Record<string, [number, number]> = { ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1] };

/// Squares to click, drag over and type in. `changed` gets every new chart, `undo` is called for Ctrl+Z.
export function chartEditor(changed: (chart: Chart) => void, undo: () => void): ChartEditor {
  const state = {
    chart: ['KK', 'KK'] as Chart, inTheRound: false, cursor: { row: 1, column: 0 } as Cell, anchor: 1,
    brush: undefined as StitchLetter | undefined, copied: [] as Chart, drawn: undefined as DrawnChart | undefined, pressed: false,
  };
  const canvas = h('canvas', { class: 'chart', tabindex: 0, role: 'application', 'aria-roledescription': 'knitting chart', 'aria-describedby': 'chart-keys' });
  const spoken = h('p', { class: 'chart-status', role: 'status' });
  const cursor = h('span', { class: 'chart-cursor' });  // what scrolls into sight: a canvas is one thing to the browser
  const frame = h('div', { class: 'chart-frame' }, h('div', { class: 'chart-sheet' }, canvas, cursor));
  const rows = (): [number, number] => [Math.min(state.anchor, state.cursor.row), Math.max(state.anchor, state.cursor.row)];

  const draw = (): void => {
    const layout = layoutOf(state.chart, frame.clientWidth || 320);
    const { chart, inTheRound } = state;
    state.drawn = drawChart(canvas, { chart, inTheRound, cursor: state.cursor, rows: rows(), focused: document.activeElement === canvas }, layout, state.drawn);
    const kind = state.chart[state.cursor.row]?.[state.cursor.column] === 'P' ? 'purl' : 'knit';
    const [top, bottom] = rows();
    const chosen = top === bottom ? '' : `; courses ${courseOfRow(state.chart, bottom)} to ${courseOfRow(state.chart, top)} chosen`;
    const text = `Course ${courseOfRow(state.chart, state.cursor.row)}, wale ${state.cursor.column + 1}: ${kind}${chosen}`;
    if (spoken.textContent !== text) spoken.textContent = text;
    canvas.setAttribute('aria-label', `Chart of ${state.chart.length} courses and ${width(state.chart)} wales`);
    // For tests and helpers that cannot see squares.
    Object.assign(canvas.dataset, { cell: layout.cell, left: layout.left, courses: state.chart.length, wales: width(state.chart) });
  };
  const revealCursor = (): void => {
    const layout = layoutOf(state.chart, frame.clientWidth || 320);
    const { x, y } = placeOfCell(layout, state.cursor);
    Object.assign(cursor.style, { left: `${x}px`, top: `${y}px`, width: `${layout.cell}px`, height: `${layout.cell}px` });
    cursor.scrollIntoView({ block: 'nearest', inline: 'nearest' });
  };
  const give = (chart: Chart): void => {
    if (chart === state.chart) return draw();
    state.chart = chart;
    draw();
    changed(chart);
  };
  const moveTo = (row: number, column: number, extend: boolean): void => {
    state.cursor = { row: Math.min(Math.max(row, 0), state.chart.length - 1), column: Math.min(Math.max(column, 0), width(state.chart) - 1) };
    if (!extend) state.anchor = state.cursor.row;
    draw();
  };
  const copy = (): void => {
    state.copied = copyRows(state.chart, ...rows());
    spoken.textContent = `${state.copied.length} ${state.copied.length === 1 ? 'row' : 'rows'} copied`;
  };
  const paste = (): void => {
    if (state.copied.length === 0) spoken.textContent = 'There is nothing to paste: copy rows first.';
    else give(pasteRows(state.chart, state.copied, rows()[1]));
  };
  const place = (event: PointerEvent): ReturnType<typeof cellAt> => {
    const box = canvas.getBoundingClientRect();
    return cellAt(state.chart, layoutOf(state.chart, frame.clientWidth || 320), event.clientX - box.left, event.clientY - box.top);
  };

  canvas.addEventListener('pointerdown', (event) => {
    const { cell, inside } = place(event);
    state.pressed = true;  // on what is in sight
    canvas.focus({ preventScroll: true });
    state.pressed = false;
    event.preventDefault();
    moveTo(cell.row, cell.column, event.shiftKey);
    if (!inside || event.shiftKey) return;
    canvas.setPointerCapture(event.pointerId);
    state.brush = state.chart[cell.row][cell.column] === 'K' ? 'P' : 'K';
    give(paint(state.chart, cell, state.brush));
  });
  canvas.addEventListener('pointermove', (event) => {
    if (!state.brush || event.buttons === 0) return;
    const { cell } = place(event);
    const painted = paintLine(state.chart, state.cursor, cell, state.brush);
    state.cursor = cell;
    state.anchor = cell.row;
    give(painted);
  });
  const lift = (): void => { state.brush = undefined; };
  canvas.addEventListener('pointerup', lift);
  canvas.addEventListener('pointercancel', lift);

  canvas.addEventListener('keydown', (event) => {
    const key = event.key.toLowerCase();
    const { row, column } = state.cursor;
    if (event.ctrlKey || event.metaKey) {
      const actions: Record<string, () => void> = { c: copy, v: paste, z: undo };
      if (!(key in actions)) return;
      actions[key]();
    } else if (event.key in moves) {
      moveTo(row + moves[event.key][0], column + moves[event.key][1], event.shiftKey);
    } else if (key === 'k' || key === 'p') {
      const letter = key.toUpperCase() as StitchLetter;
      give(paint(state.chart, state.cursor, letter));
      moveTo(row, column + 1, false);
    } else if (key === ' ') {
      give(paint(state.chart, state.cursor, state.chart[row][column] === 'K' ? 'P' : 'K'));
    } else if (key === 'home' || key === 'end') {
      moveTo(row, key === 'home' ? 0 : width(state.chart) - 1, event.shiftKey);
    } else {
      return;
    }
    revealCursor();
    event.preventDefault();
  });
  canvas.addEventListener('focus', () => {
    draw();
    // The browser scrolls to the whole canvas first.
    if (!state.pressed) requestAnimationFrame(() => document.activeElement === canvas && revealCursor());
  });
  canvas.addEventListener('blur', draw);
  const observer = new ResizeObserver(draw);
  observer.observe(frame);
  const stopDark = dark.subscribe(() => requestAnimationFrame(draw));

  const show = (chart: Chart, inTheRound: boolean): void => {
    const otherSize = chart.length !== state.chart.length || width(chart) !== width(state.chart);
    Object.assign(state, { chart, inTheRound });
    if (otherSize) Object.assign(state, { cursor: { row: chart.length - 1, column: 0 }, anchor: chart.length - 1 });
    state.anchor = Math.min(state.anchor, chart.length - 1);
    moveTo(state.cursor.row, state.cursor.column, true);
  };
  return {
    element: h('div', { class: 'chart-editor' }, frame, spoken), canvas, show, copy, paste,
    leave: () => {
      observer.disconnect();
      stopDark();
    },
  };
}
