// SPDX-License-Identifier: MIT
// Where the wall time of a run goes.
import { h } from '../ui/dom';

export interface TimeShare {
  name: string;
  share: number;  // of the wall time, 0 to 1
  light: string;  // colours, on a light and on a dark panel
  dark: string;
}

type Look = readonly [name: string, light: string, dark: string];

// In the order of a run and of a Newton iteration.
const phases: Readonly<Record<string, Look>> = {
  choosing_effects: ['choosing effects', '#4a2511', '#efe3c4'],
  begin_step: ['step set-up', '#8c248a', '#aa4fbb'],
  energy: ['energies', '#e0a100', '#fcbf64'],
  assembly: ['forces and stiffness', '#6088f3', '#75a7f3'],
  factor: ['factorisation', '#0b3f6b', '#3d63c9'],
  solve: ['linear solves', '#3996ba', '#97dcf2'],
  step_limits: ['step limits', '#e45607', '#d0693a'],
  loose_ends: ['loose ends', '#099f82', '#45a87b'],
};
const rest: Look = ['the rest', '#8d959b', '#79838b'];
const least = 0.005;  // what is less goes to the rest

function lookOf(phase: string): Look {
  return Object.hasOwn(phases, phase) ? phases[phase] : [phase.replaceAll('_', ' '), rest[1], rest[2]];
}

/// The shares of all phases and of the rest, always in one order; none where nothing is known. `wall` in s; where it is
/// less than all phases take, theirs count.
export function timeShares(byPhase: Readonly<Record<string, number>> | null | undefined, wall = 0): TimeShare[] {
  const order = Object.keys(phases);
  const place = (phase: string): number => (order.includes(phase) ? order.indexOf(phase) : order.length);
  const known = Object.entries(byPhase ?? {}).filter(([, seconds]) => seconds > 0).sort(([a], [b]) => place(a) - place(b) || a.localeCompare(b));
  const total = Math.max(wall, known.reduce((sum, [, seconds]) => sum + seconds, 0));
  if (known.length === 0) return [];
  const shown = known.map(([phase, seconds]) => ({ look: lookOf(phase), share: seconds / total })).filter(({ share }) => share >= least);
  const left = 1 - shown.reduce((sum, { share }) => sum + share, 0);
  return [...shown, ...(left >= least ? [{ look: rest, share: left }] : [])].map(({ look: [name, light, dark], share }) => ({ name, share, light, dark }));
}

function coloured(place: string, { light, dark }: TimeShare): HTMLElement {
  const part = h('span', { class: place });
  part.style.setProperty('--light', light);
  part.style.setProperty('--dark', dark);
  return part;
}

function bar(shares: readonly TimeShare[]): HTMLElement {
  return h('div', { class: 'time-bar', 'aria-hidden': 'true' }, ...shares.map((share) => {
    const part = coloured('time-part', share);
    part.style.flexGrow = String(share.share);
    return part;
  }));
}

export interface TimeSharesView {
  element: HTMLElement;
  /// Hides itself where there are none.
  show(shares: readonly TimeShare[], title: string): void;
}

export function timeSharesView(): TimeSharesView {
  const place = h('div', {});
  const element = h('div', { class: 'time-shares', role: 'group', hidden: true }, place);
  const state = { drawn: '' };
  const show = (shares: readonly TimeShare[], title: string): void => {
    element.hidden = shares.length === 0;
    element.ariaLabel = title;
    const texts = shares.map(({ name, share }) => `${name} ${Math.round(100 * share)} %`);
    const drawn = [title, ...texts].join();
    if (drawn === state.drawn) return;
    state.drawn = drawn;
    place.replaceChildren(bar(shares), h('ul', { class: 'series-legend' }, h('li', { class: 'time-title' }, title),
      ...shares.map((share, index) => h('li', {}, coloured('time-swatch', share), texts[index]))));
  };
  return { element, show };
}
