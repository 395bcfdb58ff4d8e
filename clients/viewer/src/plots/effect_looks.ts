// SPDX-License-Identifier: MIT
// How lines of plots look. Every term of the energy keeps its look from job to job. Lines of one dash pattern stay apart
// for the colour-blind too (protanopia, deuteranopia); a test measures that.

export interface Look {
  light: string;  // on a light panel
  dark: string;
  dash: string;   // of stroke-dasharray, in px
}

const solid = 'none';
const dashed = '7 3';
const dotted = '2 2';
const dashDot = '8 2.5 2 2.5';

export const effectLooks: Readonly<Record<string, Look>> = {
  kinetic: { light: '#6088f3', dark: '#75a7f3', dash: solid },
  gravity: { light: '#634a15', dark: '#d89d08', dash: solid },
  stretch: { light: '#099f82', dark: '#69d4b1', dash: solid },
  bending: { light: '#e45607', dark: '#b55e38', dash: solid },
  wrapping: { light: '#8c248a', dark: '#aa4fbb', dash: solid },
  bending_jamming: { light: '#342dd3', dark: '#545dfe', dash: dashed },
  contact_length: { light: '#3996ba', dark: '#97dcf2', dash: dashed },
  parallel_contact: { light: '#1f6d4f', dark: '#45a87b', dash: dashed },
  self_collision: { light: '#4c6eab', dark: '#738db7', dash: dotted },
  colliders: { light: '#a58558', dark: '#fcbf64', dash: dotted },
  body_contact: { light: '#72621a', dark: '#ac8e1d', dash: dotted },
  dead_load: { light: '#307a7b', dark: '#258e8d', dash: dashDot },
  body_gravity: { light: '#2277f4', dark: '#4486e7', dash: dashDot },
};

/// Of a plot with one line, or a term that is newer than this viewer.
export const plainLook: Look = { light: '#0b5c86', dark: '#7cc4ec', dash: solid };

export function lookOf(term: string): Look {
  return Object.hasOwn(effectLooks, term) ? effectLooks[term] : plainLook;
}
