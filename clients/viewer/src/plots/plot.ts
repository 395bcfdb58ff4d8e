// SPDX-License-Identifier: MIT
import { shortNumber } from '../scene/number_text';
import { h, svg } from '../ui/dom';
import { lookOf } from './effect_looks';
import type { PlotData, Series } from './history';
import { logTicks, ticks } from './ticks';

const size = { width: 420, height: 190, left: 58, right: 24, top: 10, bottom: 30 };

interface Axis {
  low: number;
  high: number;
  place(value: number): number;
  ticks: number[];
}

function shown(plot: PlotData, value: number): boolean {
  return Number.isFinite(value) && (!plot.logarithmic || value > 0);
}

function xAxis(plot: PlotData): Axis {
  const [low, high] = [Math.min(0, plot.x[0] ?? 0), Math.max(plot.x[plot.x.length - 1] ?? 1, 1e-9)];
  const width = size.width - size.left - size.right;
  return { low, high, place: (value) => size.left + ((value - low) / (high - low)) * width, ticks: ticks(low, high, 5) };
}

function yAxis(plot: PlotData): Axis {
  const values = plot.series.flatMap((series) => series.y.filter((value) => shown(plot, value)));
  let low = values.reduce((a, b) => Math.min(a, b), Infinity);
  let high = values.reduce((a, b) => Math.max(a, b), -Infinity);
  if (low > high) [low, high] = [plot.logarithmic ? 0.1 : 0, 1];
  if (plot.logarithmic) [low, high] = [low / 1.5, high * 1.5];
  else [low, high] = [Math.min(low, 0), high === Math.min(low, 0) ? low + 1 : high];
  const height = size.height - size.top - size.bottom;
  const scale = plot.logarithmic ? Math.log10 : (value: number): number => value;
  const part = (value: number): number => (scale(value) - scale(low)) / (scale(high) - scale(low));
  return {
    low, high,
    place: (value) => size.height - size.bottom - part(value) * height,
    ticks: plot.logarithmic ? logTicks(low, high, 4) : ticks(low, high, 4),
  };
}

const mostDrawn = 2000;  // points of a line: more than its pixels are of no use

/// A line through the points; a small circle around one that stands alone.
export function line(plot: PlotData, series: Series, x: Pick<Axis, 'place'>, y: Pick<Axis, 'place'>): string {
  const step = Math.max(1, Math.ceil(series.y.length / mostDrawn));
  let path = '';
  let run = 0;  // points since the line was set down
  const lift = (): void => {
    if (run === 1) path += 'm-2 0a2 2 0 1 0 4 0a2 2 0 1 0 -4 0';
    run = 0;
  };
  for (let index = 0; index < series.y.length; index += step) {
    const value = series.y[index];
    const visible = shown(plot, value);
    if (visible) path += `${run++ > 0 ? 'L' : 'M'}${x.place(plot.x[index]).toFixed(1)} ${y.place(value).toFixed(1)}`;
    else lift();
  }
  lift();
  return path;
}

function axes(x: Axis, y: Axis): SVGElement[] {
  const bottom = size.height - size.bottom;
  return [
    ...y.ticks.map((tick) => svg('g', {},
      svg('line', { class: 'grid', x1: size.left, x2: size.width - size.right, y1: y.place(tick), y2: y.place(tick) }),
      svg('text', { class: 'tick', x: size.left - 6, y: y.place(tick) + 4, 'text-anchor': 'end' }, shortNumber(tick)))),
    ...x.ticks.map((tick) => svg('g', {},
      svg('line', { class: 'grid', x1: x.place(tick), x2: x.place(tick), y1: bottom, y2: bottom + 4 }),
      svg('text', { class: 'tick', x: x.place(tick), y: bottom + 17, 'text-anchor': 'middle' }, shortNumber(tick)))),
  ];
}

const resolved = 1e-3;  // of the largest value of a plot: less than a pixel

/// What a plot shows, in words.
export function describePlot(plot: PlotData): string {
  const most = plot.series.flatMap(({ y }) => y.filter((value) => shown(plot, value))).reduce((a, b) => Math.max(a, Math.abs(b)), 0);
  const least = plot.logarithmic ? 0 : resolved * most;
  const last = plot.series.map((series) => `${series.name} ${shortNumber(series.y[series.y.length - 1], least)} ${plot.unit}`.trim());
  return `${plot.title} over ${shortNumber(plot.x[plot.x.length - 1] ?? 0)} s. At the end: ${last.join(', ')}.`;
}

function path(series: Series, d: string): SVGElement {
  const { light, dark, dash } = lookOf(series.term);
  const element = svg('path', { class: 'series', d, 'stroke-dasharray': dash });
  element.style.setProperty('--light', light);
  element.style.setProperty('--dark', dark);
  return element;
}

function legendOf(plot: PlotData): HTMLElement {
  return h('ul', { class: 'series-legend' }, ...plot.series.map((series) =>
    h('li', {}, svg('svg', { class: 'swatch', viewBox: '0 0 24 4', 'aria-hidden': 'true' }, path(series, 'M0 2H24')), series.name)));
}

export interface PlotFigure {
  element: HTMLElement;
  /// Moves the line that marks a simulated time in s.
  showTime(t: number): void;
}

/// A plot over simulated time.
export function plotFigure(plot: PlotData): PlotFigure {
  const [x, y] = [xAxis(plot), yAxis(plot)];
  const now = svg('line', { class: 'now', y1: size.top, y2: size.height - size.bottom });
  const picture = svg('svg', { class: 'plot', viewBox: `0 0 ${size.width} ${size.height}`, role: 'img', 'aria-label': describePlot(plot) },
    ...axes(x, y),
    ...plot.series.map((series) => path(series, line(plot, series, x, y))), now);
  const unit = plot.unit ? ` in ${plot.unit}` : '';
  const legend = plot.series.length > 1 && legendOf(plot);
  const element = h('figure', { class: 'plot-figure' }, h('figcaption', {}, `${plot.title}${unit}, over time in s`), picture, legend);
  const showTime = (t: number): void => {
    const at = x.place(Math.min(Math.max(t, x.low), x.high)).toFixed(1);
    now.setAttribute('x1', at);
    now.setAttribute('x2', at);
  };
  return { element, showTime };
}
