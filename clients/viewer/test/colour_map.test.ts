// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { colourAt, colourTable, type Colour } from '../src/draw/colour_map';

/// CIE lightness of an sRGB colour.
function lightness(colour: Colour): number {
  const [r, g, b] = colour.map((value) => (value / 255 <= 0.04045 ? value / 255 / 12.92 : ((value / 255 + 0.055) / 1.055) ** 2.4));
  const y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
  return 116 * Math.cbrt(y) - 16;
}

const parts = Array.from({ length: 11 }, (_, index) => index / 10);

describe('colour maps', () => {
  it('grow lighter in even steps for amounts', () => {
    const steps = parts.slice(1).map((part, index) => lightness(colourAt(part, false)) - lightness(colourAt(parts[index], false)));
    for (const step of steps) {
      expect(step).toBeGreaterThan(4);
      expect(step).toBeLessThan(12);
    }
  });
  it('darken alike to both sides for signed numbers', () => {
    for (const part of parts.slice(0, 5)) {
      const [below, above] = [lightness(colourAt(part, true)), lightness(colourAt(1 - part, true))];
      expect(Math.abs(below - above)).toBeLessThan(7);
      expect(lightness(colourAt(part + 0.1, true))).toBeGreaterThan(below);
    }
  });
  it('hold their ends', () => {
    expect(colourAt(-1, false)).toEqual(colourAt(0, false));
    expect(colourAt(2, true)).toEqual(colourAt(1, true));
    expect(colourTable(false).length).toBe(1024);
  });
});
