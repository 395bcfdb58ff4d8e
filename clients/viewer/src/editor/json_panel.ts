// SPDX-License-Identifier: MIT
import type { JsonObject } from '../scene/field';
import { readScene } from '../scene/scene_file';
import { button, h } from '../ui/dom';

export interface JsonPanel {
  element: HTMLElement;
  /// The scene has changed.
  show(): void;
}

/// The scene as its file reads, to edit what the form does not show.
export function jsonPanel(text: () => string, load: (scene: JsonObject) => void): JsonPanel {
  const area = h('textarea', { rows: 18, spellcheck: 'false', 'aria-label': 'Scene as JSON', class: 'code', 'aria-describedby': 'json-error' });
  const error = h('p', { class: 'field-error', role: 'alert', id: 'json-error', hidden: true });
  const use = button('Use this JSON', () => {
    try {
      load(readScene(area.value));
      error.hidden = true;
    } catch (problem) {
      error.textContent = problem instanceof Error ? problem.message : String(problem);
      error.hidden = false;
    }
  }, { class: 'small' });
  const details = h('details', { class: 'section' }, h('summary', {}, h('h2', {}, 'Scene as JSON')), area, error, use);
  const show = (): void => {
    if (!details.open || document.activeElement === area) return;
    area.value = text();
    error.hidden = true;
  };
  details.addEventListener('toggle', show);
  return { element: details, show };
}
