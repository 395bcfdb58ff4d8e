// SPDX-License-Identifier: MIT

/// "frame 359 of 100000": frames count from 0, the start, to the last one; `planned` is how many there will be, 0 where
/// nobody knows. Negative: there is none.
export function frameText(index: number, planned: number): string {
  if (index < 0) return 'no frame yet';
  return planned > 0 ? `frame ${index} of ${planned - 1}` : `frame ${index}`;
}
