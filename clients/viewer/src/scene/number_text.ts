// SPDX-License-Identifier: MIT

/// A number as a person reads it, exact to what a double holds of a decimal that was typed.
export function numberText(value: number): string {
  return String(Number(value.toPrecision(12)));
}

// "1,000" is a thousand to some and one to others: neither is guessed.
const betweenThousands = /^[-+]?[1-9]\d{0,2},\d{3}(?!\d)/;

/// What was typed into a field of unit `scale`, in the schema's unit, with a decimal point or comma; undefined for an empty
/// one. Throws for other text.
export function parseNumber(typed: string, scale: number): number | undefined {
  const text = betweenThousands.test(typed.trim()) ? typed.trim() : typed.trim().replace(',', '.');
  if (text === '') return undefined;
  const value = /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(text) ? Number(text) : NaN;
  if (!Number.isFinite(value)) throw new Error(`is “${typed.trim()}”, expected a number`);
  return scale === 1 ? value : Number((value * scale).toPrecision(15));
}

/// Numbers with spaces or commas between them; a decimal point then is a point. Throws for other text.
export function parseNumbers(typed: string): number[] {
  return typed.split(/[\s,]+/).filter((word) => word !== '').map((word) => {
    const value = /^[-+]?0\d/.test(word) ? NaN : Number(/^[-+.\de]+$/i.test(word) ? word : NaN);  // "000" is the rest of "1,000"
    if (!Number.isFinite(value)) throw new Error(`has “${word}”, expected numbers`);
    return value;
  });
}

/// What was typed into a field of whole numbers; as text where no double holds it.
export function parseWhole(typed: string): number | string | undefined {
  const value = parseNumber(typed, 1);
  if (value === undefined || Number.isSafeInteger(value)) return value;
  if (!Number.isInteger(value)) throw new Error(`is ${numberText(value)}, expected a whole number`);
  if (!/^[-+]?\d+$/.test(typed.trim())) throw new Error(`is “${typed.trim()}”, expected all digits of a whole number`);
  return BigInt(typed.trim().replace('+', '')).toString();
}

/// Three significant digits, and no more places than they need: for measured values. What is smaller than `least` is
/// rounding, and reads 0.
export function shortNumber(value: number, least = 0): string {
  if (!Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (size < least) return '0';
  if (size !== 0 && (size < 1e-3 || size >= 1e5)) return value.toExponential(2).replace('e+', 'e');
  return String(Number(value.toPrecision(3)));
}

/// A time that is known roughly: "12 s", "1.5 min", "20 h".
export function roughTime(seconds: number): string {
  const [unit, length] = seconds < 90 ? ['s', 1] : seconds < 5400 ? ['min', 60] : seconds < 129_600 ? ['h', 3600] : ['days', 86_400];
  return `${Number((seconds / (length as number)).toPrecision(2))} ${unit}`;
}
