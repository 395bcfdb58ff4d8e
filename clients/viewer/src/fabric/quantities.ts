// SPDX-License-Identifier: MIT
// What yarn can be coloured by, one number a visit.
import { slidLengths, strains, visitMeans, wrapAngles } from './derive';
import type { Fabric, Frame } from './fabric';

export type QuantityName = 'none' | 'stretch' | 'tension' | 'wrap' | 'slid';

export interface Quantity {
  name: QuantityName;
  label: string;
  unit: string;
  /// The smallest size that is told from 0, in `unit`: far above rounding, and below what matters of a fabric.
  least: number;
  /// Shown around zero, with two colours.
  diverging: boolean;
}

export const quantities: readonly Quantity[] = [
  { name: 'none', label: 'Plain yarn', unit: '', least: 0, diverging: false },
  { name: 'stretch', label: 'Stretch', unit: '%', least: 1e-6, diverging: false },
  { name: 'tension', label: 'Tension', unit: 'mN', least: 1e-6, diverging: false },
  { name: 'wrap', label: 'Wrapping angle', unit: '°', least: 1e-3, diverging: true },
  { name: 'slid', label: 'Sliding', unit: 'mm', least: 1e-6, diverging: true },
];

export function quantityOf(name: string): Quantity {
  return quantities.find((candidate) => candidate.name === name) ?? quantities[0];
}

/// Signed so that the wrapping effect drives every contact towards the same positive angle at rest, knit or purl, left
/// or right; mean of the two diagonals, in rad. NaN where a contact has neither.
export function contactWraps(fabric: Fabric, frame: Frame): Float64Array {
  const angles = wrapAngles(fabric, frame);
  return Float64Array.from(fabric.contacts, (contact, index) => {
    const [a, b] = [angles[2 * index], angles[2 * index + 1]];
    const mean = Number.isNaN(a) ? b : Number.isNaN(b) ? a : (a + b) / 2;
    return contact.sign * mean;
  });
}

function wrapsOfVisits(fabric: Fabric, frame: Frame): Float64Array {
  const values = new Float64Array(fabric.numVisits).fill(NaN);
  const wraps = contactWraps(fabric, frame);
  fabric.contacts.forEach((contact, index) => {
    for (const visit of [...contact.uVisit, ...contact.vVisit]) if (visit >= 0) values[visit] = (wraps[index] * 180) / Math.PI;
  });
  return values;
}

/// In the quantity's unit; NaN where it means nothing.
export function valuesOfVisits(name: QuantityName, fabric: Fabric, frame: Frame, reference: Frame): Float64Array {
  switch (name) {
    case 'stretch': return visitMeans(fabric, strains(fabric, frame)).map((strain) => 100 * strain);
    case 'tension': return visitMeans(fabric, strains(fabric, frame)).map((strain) => 1000 * fabric.stretch * strain);
    case 'wrap': return wrapsOfVisits(fabric, frame);
    case 'slid': return slidLengths(fabric, frame, reference).map((length) => 1000 * length);
    case 'none': return new Float64Array(fabric.numVisits).fill(NaN);
  }
}

/// Smallest and largest value, around zero if the quantity diverges; [0, 1] where there is none. Its ends differ by what
/// is told from 0 at `least`.
export function rangeOf(values: Float64Array, diverging: boolean, least = 1e-6): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) {
    if (Number.isNaN(value)) continue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  if (low > high) return [0, 1];
  if (diverging) {
    const most = Math.max(Math.abs(low), Math.abs(high), least);
    return [-most, most];
  }
  if (high - low <= 2 * least) high = low + 2 * least;
  return [low, high];
}
