// SPDX-License-Identifier: MIT
import { quantityOf, type QuantityName } from '../fabric/quantities';
import type { StitchFacts } from '../fabric/stitch_facts';
import { shortNumber } from '../scene/number_text';
import { button, h } from '../ui/dom';

export interface StitchPanel {
  element: HTMLElement;
  show(facts: StitchFacts | undefined): void;
}

export function rowsOfStitch(facts: StitchFacts): [string, string][] {
  const text = (name: QuantityName, value: number): string => shortNumber(value, quantityOf(name).least);
  return [
    ['Stretch of the loop, mean', `${text('stretch', 100 * facts.meanStretch)} %`],
    ['Largest tension', `${text('tension', 1000 * facts.mostTension)} mN`],
    ...facts.wraps.map(({ where, angle }): [string, string] =>
      [`Wrapping angle, ${where}`, Number.isNaN(angle) ? '–' : `${text('wrap', (angle * 180) / Math.PI)}°`]),
    ['Slid, at most', `${text('slid', 1000 * facts.slid)} mm`],
    ['Yarn in the loop', `${shortNumber(1000 * facts.length)} mm`],
  ];
}

/// Numbers of the stitch that was clicked; `choose(course, wale)` picks one without a pointer, and says so where there is
/// none.
export function stitchPanel(choose: (course: number, wale: number) => string | undefined, clear: () => void): StitchPanel {
  const title = h('p', { class: 'stitch-title', role: 'status' });
  const numbers = h('dl', { class: 'numbers' });
  const box = (label: string): HTMLInputElement => h('input', { type: 'number', min: 1, value: 1, 'aria-label': label, 'aria-describedby': 'pick-error' });
  const [course, wale] = [box('Course of the stitch'), box('Wale of the stitch')];
  const pick = h('form', { class: 'pick', novalidate: true }, h('span', {}, 'Course'), course, h('span', {}, 'wale'), wale,
    h('button', { type: 'submit' }, 'Show'), button('Clear', () => {
      complain(undefined);
      clear();
    }));
  const error = h('p', { class: 'field-error', role: 'alert', id: 'pick-error', hidden: true });
  const complain = (message: string | undefined): void => {
    for (const input of [course, wale]) {
      if (message) input.setAttribute('aria-invalid', 'true');
      else input.removeAttribute('aria-invalid');
    }
    error.textContent = message ?? '';
    error.hidden = !message;
  };
  pick.addEventListener('submit', (event) => {
    event.preventDefault();
    complain(choose(Number(course.value), Number(wale.value)));
  });
  const show = (facts: StitchFacts | undefined): void => {
    const text = facts ? `Course ${facts.course}, wale ${facts.wale}: ${facts.kind}` : 'Click a stitch in the picture, or name one:';
    if (title.textContent !== text) title.textContent = text;
    if (facts && document.activeElement !== course && document.activeElement !== wale) {
      course.value = String(facts.course);
      wale.value = String(facts.wale);
    }
    numbers.replaceChildren(...(facts ? rowsOfStitch(facts) : []).flatMap(([name, value]) => [h('dt', {}, name), h('dd', {}, value)]));
  };
  show(undefined);
  return { element: h('section', { class: 'panel', 'aria-label': 'Stitch' }, h('h2', {}, 'Stitch'), title, pick, error, numbers), show };
}
