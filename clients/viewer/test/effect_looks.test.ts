// SPDX-License-Identifier: MIT
import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { effectLooks, lookOf, plainLook, type Look } from '../src/plots/effect_looks';
import { parseHistory, plotsOf } from '../src/plots/history';

type Vector = readonly number[];
type Theme = 'light' | 'dark';

function linear(colour: string): Vector {
  return [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16) / 255).map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
}

function times(matrix: readonly Vector[], v: Vector): number[] {
  return matrix.map((row) => row.reduce((sum, factor, index) => sum + factor * v[index], 0));
}

/// WCAG 2.
function contrast(a: string, b: string): number {
  const [low, high] = [a, b].map((colour) => times([[0.2126, 0.7152, 0.0722]], linear(colour))[0]).sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
}

// Machado, Oliveira and Fernandes 2009, severity 1, of linear sRGB.
const sights: Readonly<Record<string, readonly Vector[]>> = {
  usual: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanopia: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  deuteranopia: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
};

/// Ottosson's Oklab: distances as seen; about 0.02 can just be told apart side by side.
function oklab(rgb: Vector): number[] {
  const lms = times([[0.4122214708, 0.5363325363, 0.0514459929], [0.2119034982, 0.6806995451, 0.1073969566], [0.0883024619, 0.2817188376, 0.6299787005]], rgb);
  return times([[0.2104542553, 0.793617785, -0.0040720468], [1.9779984951, -2.428592205, 0.4505937099], [0.0259040371, 0.7827717662, -0.808675766]], lms.map(Math.cbrt));
}

function distance(a: string, b: string, sight: string): number {
  const [p, q] = [a, b].map((colour) => oklab(times(sights[sight], linear(colour)).map((c) => Math.min(Math.max(c, 0), 1))));
  return Math.hypot(...p.map((value, index) => value - q[index]));
}

function pairs(wanted: (a: Look, b: Look) => boolean): [string, string][] {
  const names = Object.keys(effectLooks);
  return names.flatMap((a, index) => names.slice(0, index).map((b): [string, string] => [a, b]))
    .filter(([a, b]) => wanted(effectLooks[a], effectLooks[b]));
}

/// Of these pairs those that are nearer than `least`.
function tooNear(found: readonly [string, string][], theme: Theme, sight: string, least: number): string[] {
  return found.filter(([a, b]) => distance(effectLooks[a][theme], effectLooks[b][theme], sight) < least).map(([a, b]) => `${a}, ${b}`);
}

const style = readFileSync(new URL('../src/style/base.css', import.meta.url), 'utf8');
const panels = [...style.matchAll(/--panel: (#[0-9a-f]{6})/g)].map((match) => match[1]);

describe.each([['light', panels[0]], ['dark', panels[1]]] as const)('lines of effects on a %s panel', (theme, panel) => {
  it('are seen on it', () => {
    const faint = Object.entries({ ...effectLooks, plainLook }).filter(([, look]) => contrast(look[theme], panel) < 3);
    expect(faint).toEqual([]);
  });
  it.each(Object.keys(sights))('are told apart, sight: %s', (sight) => {
    expect(tooNear(pairs((a, b) => a.dash === b.dash), theme, sight, 0.13)).toEqual([]);
    expect(tooNear(pairs((a, b) => a.dash !== b.dash), theme, sight, 0.055)).toEqual([]);
  });
  it('of a usual plot are well apart', () => {
    const usual = new Set(['kinetic', 'gravity', 'stretch', 'bending', 'wrapping', 'bending_jamming', 'contact_length', 'parallel_contact']);
    expect(tooNear(pairs(() => true).filter(([a, b]) => usual.has(a) && usual.has(b)), theme, 'usual', 0.1)).toEqual([]);
  });
});

describe('looks', () => {
  it('are there for every term that stores energy', () => {
    const folder = new URL('../../../core/force/', import.meta.url);
    const terms = readdirSync(folder).filter((file) => file.endsWith('.h')).flatMap((file) =>
      [...readFileSync(new URL(file, folder), 'utf8').matchAll(/kName = "(\w+)"/g)].map((match) => match[1]));
    const storesNone = /inertia$|friction$|^damping_|^air_drag$/;
    expect(terms.filter((term) => !storesNone.test(term)).concat('kinetic').sort()).toEqual(Object.keys(effectLooks).sort());
  });
  it('stay the same whatever else a job has', () => {
    const looks = (columns: string): Record<string, Look> => {
      const [{ series }] = plotsOf(parseHistory(`t_s,${columns}\n0,${columns.replaceAll(/\w+/g, '1')}\n`));
      return Object.fromEntries(series.map(({ name, term }) => [name, lookOf(term)]));
    };
    const [few, many] = [looks('stretch_j,bending_jamming_j'), looks('kinetic_j,bending_j,bending_jamming_j,gravity_j,stretch_j')];
    expect(few).toEqual({ stretch: effectLooks.stretch, 'bending jamming': effectLooks.bending_jamming });
    expect(many).toMatchObject(few);
  });
});
