// SPDX-License-Identifier: MIT
// Perceptually uniform colours: viridis for amounts, a blue-white-red ramp of even lightness steps for signed ones. Each
// is a few colours of equal distance, sRGB, linear in between.

export type Colour = readonly [number, number, number];

const sequential: readonly Colour[] = [
  [68, 1, 84], [72, 36, 117], [65, 68, 135], [53, 95, 141], [42, 120, 142], [33, 145, 140],
  [34, 168, 132], [68, 191, 112], [122, 209, 81], [189, 223, 38], [253, 231, 37],
];

const diverging: readonly Colour[] = [
  [0, 72, 140], [37, 103, 165], [84, 136, 189], [132, 169, 210], [182, 203, 228], [238, 236, 232],
  [232, 194, 178], [217, 151, 128], [197, 107, 83], [170, 62, 46], [134, 14, 24],
];

export function colourAt(part: number, isDiverging: boolean): Colour {
  const stops = isDiverging ? diverging : sequential;
  const place = Math.min(Math.max(part, 0), 1) * (stops.length - 1);
  const index = Math.min(Math.floor(place), stops.length - 2);
  const mix = (c: 0 | 1 | 2): number => stops[index][c] + (place - index) * (stops[index + 1][c] - stops[index][c]);
  return [mix(0), mix(1), mix(2)];
}

/// 256 colours, four bytes each.
export function colourTable(isDiverging: boolean): Uint8Array {
  const table = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; ++i) table.set([...colourAt(i / 255, isDiverging).map(Math.round), 255], 4 * i);
  return table;
}
