// SPDX-License-Identifier: MIT

/// A number as a person reads it, exact to what a double holds of a decimal that was typed.
export function numberText(value: number): string {
  return String(Number(value.toPrecision(12)));
}

/// What was typed into a field of unit `scale`, in the schema's unit; undefined for an empty one. Throws for other text.
export function parseNumber(typed: string, scale: number): number | undefined {
  const text = typed.trim().replace(',', '.');
  if (text === '') return undefined;
  const value = /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(text) ? Number(text) : NaN;
  if (!Number.isFinite(value)) throw new Error(`is “${typed.trim()}”, expected a number`);
  return scale === 1 ? value : Number((value * scale).toPrecision(15));
}

/// Likewise a whole number; as text where no double holds it.
export function parseWhole(typed: string): number | string | undefined {
  const value = parseNumber(typed, 1);
  if (value === undefined || Number.isSafeInteger(value)) return value;
  if (!Number.isInteger(value)) throw new Error(`is ${numberText(value)}, expected a whole number`);
  if (!/^[-+]?\d+$/.test(typed.trim())) throw new Error(`is “${typed.trim()}”, expected all digits of a whole number`);
  return BigInt(typed.trim().replace('+', '')).toString();
}

/// Three significant digits, and no more places than they need: for measured values.
export function shortNumber(value: number): string {
  if (!Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e5)) return value.toExponential(2).replace('e+', 'e');
  return String(Number(value.toPrecision(3)));
}
