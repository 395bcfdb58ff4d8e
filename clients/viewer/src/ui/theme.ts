// SPDX-License-Identifier: MIT
import { h } from './dom';
import { Signal } from './signal';

export type Theme = 'system' | 'light' | 'dark';

const key = 'slipstitch.theme';
const themes: readonly Theme[] = ['system', 'light', 'dark'];
const darkSystem = window.matchMedia('(prefers-color-scheme: dark)');

function stored(): Theme {
  try {
    return themes.find((theme) => theme === localStorage.getItem(key)) ?? 'system';
  } catch {
    return 'system';  // storage is forbidden
  }
}

function isDark(theme: Theme): boolean {
  return theme === 'dark' || (theme === 'system' && darkSystem.matches);
}

/// Whether the page is dark now.
export const dark = new Signal(isDark(stored()));

function apply(theme: Theme): void {
  document.documentElement.dataset.theme = isDark(theme) ? 'dark' : 'light';
  dark.set(isDark(theme));
}

export function startTheme(): void {
  apply(stored());
  darkSystem.addEventListener('change', () => apply(stored()));
}

export function themeChoice(): HTMLElement {
  const box = h('select', { id: 'theme' }, ...themes.map((theme) => h('option', { value: theme, selected: theme === stored() }, theme)));
  box.addEventListener('change', () => {
    try {
      localStorage.setItem(key, box.value);
    } catch {
      // Kept for this page only.
    }
    apply(box.value as Theme);
  });
  return h('span', { class: 'labelled' }, h('label', { for: 'theme' }, 'Theme'), box);
}
