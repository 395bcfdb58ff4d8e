// SPDX-License-Identifier: MIT
// Fabrics with a name, as the presets of proto/slipstitch/v1/knit.proto draw them.
import type { Chart } from './chart';

export interface KnitPreset {
  name: string;
  courses: number;
  wales: number;
  ribKnits: number;
  ribPurls: number;
}

function isKnit(preset: KnitPreset, course: number, wale: number): boolean {
  switch (preset.name) {
    case 'reverse_stockinette': return false;
    case 'garter': return course % 2 === 1;
    case 'seed': return (course + wale) % 2 === 0;
    case 'rib': return (wale - 1) % (preset.ribKnits + preset.ribPurls) < preset.ribKnits;
    default: return true;
  }
}

export function presetChart(preset: KnitPreset): Chart {
  return Array.from({ length: preset.courses }, (_, row) => {
    const course = preset.courses - row;
    return Array.from({ length: preset.wales }, (_, column) => (isKnit(preset, course, column + 1) ? 'K' : 'P')).join('');
  });
}

export const presetNames = ['stockinette', 'reverse_stockinette', 'garter', 'rib', 'seed'];

/// What the editor offers, by label.
export const presetMenu: { label: string; name: string; ribKnits: number; ribPurls: number }[] = [
  { label: 'Stockinette', name: 'stockinette', ribKnits: 1, ribPurls: 1 },
  { label: 'Reverse stockinette', name: 'reverse_stockinette', ribKnits: 1, ribPurls: 1 },
  { label: 'Garter', name: 'garter', ribKnits: 1, ribPurls: 1 },
  { label: 'Rib 1×1', name: 'rib', ribKnits: 1, ribPurls: 1 },
  { label: 'Rib 2×2', name: 'rib', ribKnits: 2, ribPurls: 2 },
  { label: 'Seed', name: 'seed', ribKnits: 1, ribPurls: 1 },
];
