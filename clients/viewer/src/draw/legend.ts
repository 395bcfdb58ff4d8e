// SPDX-License-Identifier: MIT
import { colourTable } from './colour_map';
import { quantities, quantityOf, type QuantityName } from '../fabric/quantities';
import { parseNumber, shortNumber } from '../scene/number_text';
import { h, select } from '../ui/dom';

/// What a person set; `range` undefined: from the frame shown.
export interface ColourChoice {
  name: QuantityName;
  range: readonly [number, number] | undefined;
}

export interface Legend {
  element: HTMLElement;
  show(range: readonly [number, number]): void;
}

function ramp(): HTMLCanvasElement {
  return h('canvas', { width: 256, height: 1, class: 'ramp', role: 'img', 'aria-label': 'Colours from low to high' });
}

function paintRamp(canvas: HTMLCanvasElement, diverging: boolean): void {
  const data = new ImageData(new Uint8ClampedArray(colourTable(diverging)), 256, 1);
  canvas.getContext('2d')?.putImageData(data, 0, 0);
}

/// Choice of the quantity, its colours with the range in its unit, and a lock of the range.
export function legend(choice: ColourChoice, changed: () => void): Legend {
  const canvas = ramp();
  const unit = h('span', { class: 'unit' });
  const end = (label: string): HTMLInputElement =>
    h('input', { type: 'text', inputmode: 'decimal', size: 7, 'aria-label': label, 'aria-describedby': 'range-error' });
  const error = h('p', { class: 'field-error', role: 'alert', id: 'range-error', hidden: true });
  const [low, high] = [end('Lowest value'), end('Highest value')];
  const lock = h('input', { type: 'checkbox', id: 'lock-range' });
  const scale = h('div', { class: 'scale', hidden: true }, low, canvas, high, unit,
    h('span', { class: 'labelled' }, lock, h('label', { for: 'lock-range' }, 'keep range')));

  const complain = (message: string, ...wrong: HTMLInputElement[]): void => {
    for (const input of [low, high]) {
      if (wrong.includes(input)) input.setAttribute('aria-invalid', 'true');
      else input.removeAttribute('aria-invalid');
    }
    error.textContent = message;
    error.hidden = message === '';
  };
  const readEnd = (input: HTMLInputElement): number => {
    try {
      const value = parseNumber(input.value, 1);
      if (value === undefined) throw new Error('is empty, expected a number');
      return value;
    } catch (problem) {
      complain(`${input.ariaLabel} ${(problem as Error).message}.`, input);
      return NaN;
    }
  };
  const readRange = (): void => {
    const [a, b] = [readEnd(low), readEnd(high)];
    if (Number.isNaN(a) || Number.isNaN(b)) return;
    if (!(a < b)) return complain(`Lowest value is ${a}, expected less than the highest value, ${b}.`, low, high);
    complain('');
    choice.range = [a, b];
    lock.checked = true;
    changed();
  };
  low.addEventListener('change', readRange);
  high.addEventListener('change', readRange);
  lock.addEventListener('change', () => {
    if (lock.checked) return readRange();
    choice.range = undefined;
    complain('');
    changed();
  });

  const choose = (name: string): void => {
    choice.name = name as QuantityName;
    choice.range = undefined;
    lock.checked = false;
    complain('');
    const quantity = quantityOf(name);
    scale.hidden = name === 'none';
    unit.textContent = quantity.unit;
    paintRamp(canvas, quantity.diverging);
    changed();
  };
  const element = h('div', { class: 'legend' },
    select('Colour by', quantities.map((quantity) => [quantity.name, quantity.label] as const), choice.name, choose), scale, error);
  return {
    element,
    show: ([lowest, highest]) => {
      if (choice.range || document.activeElement === low || document.activeElement === high) return;
      const { least } = quantityOf(choice.name);
      low.value = shortNumber(lowest, least);
      high.value = shortNumber(highest, least);
    },
  };
}
