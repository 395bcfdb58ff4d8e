// SPDX-License-Identifier: MIT
import { placeOf, type FieldError } from '../api/field_errors';
import { inFieldUnit } from '../scene/field_unit';
import { h } from '../ui/dom';

/// Fields without which nothing can be run, and that are empty.
export function emptyFields(form: HTMLElement): FieldError[] {
  return [...form.querySelectorAll<HTMLInputElement>('input[aria-required="true"]')].filter((input) => input.value.trim() === '').map((input) =>
    ({ path: input.closest<HTMLElement>('[data-path]')?.dataset.path ?? '', message: 'is empty, expected a number' }));
}

/// Takes the errors off a form.
function clear(form: HTMLElement): void {
  for (const element of form.querySelectorAll<HTMLElement>('.field-error')) {
    element.textContent = '';
    element.hidden = true;
  }
  for (const element of form.querySelectorAll('[aria-invalid]')) element.removeAttribute('aria-invalid');
}

function markInvalid(place: HTMLElement): void {
  const controls = /(^| )(field|effect|size|order-field)( |$)/.test(place.className)
    ? place.querySelectorAll<HTMLElement>(':scope > input, :scope > select, :scope > textarea, :scope > .vector > input, :scope > .effect-head > input')
    : [];
  for (const control of controls) control.setAttribute('aria-invalid', 'true');
}

function reveal(place: HTMLElement): void {
  for (let at: HTMLElement | null = place; at; at = at.parentElement) if (at instanceof HTMLDetailsElement) at.open = true;
}

function focusOf(place: HTMLElement): HTMLElement {
  return place.querySelector<HTMLElement>('input, select, textarea, canvas') ?? place;
}

export function headline(errors: readonly FieldError[]): string {
  if (errors.every(({ about }) => about === 'server')) return 'This did not work';
  const what = errors.every(({ about }) => about === undefined) ? 'scene' : 'job';
  return errors.length === 1 ? `This ${what} has a problem` : `This ${what} has ${errors.length} problems`;
}

/// Shows every error at its field, or at the nearest place around it, and lists all of them in `summary` with links.
export function showErrors(form: HTMLElement, summary: HTMLElement, errors: readonly FieldError[]): void {
  clear(form);
  const places = new Map([...form.querySelectorAll<HTMLElement>('[data-path]')].map((place) => [place.dataset.path ?? '', place]));
  const lines = errors.map(({ path, message }) => {
    const found = placeOf(path, (candidate) => places.has(candidate));
    const place = found === '' ? undefined : places.get(found);
    const text = path === '' ? message : `${path} ${message}`;
    if (!place) return h('li', {}, text);
    const shown = place.querySelector<HTMLElement>(':scope > .field-error');
    if (shown) {
      const line = found === path ? inFieldUnit(path, message) : text;
      shown.textContent = shown.textContent ? `${shown.textContent}; ${line}` : line;
      shown.hidden = false;
    }
    markInvalid(place);
    reveal(place);
    return h('li', {}, h('a', { href: '#', onclick: (event: Event) => {
      event.preventDefault();
      reveal(place);
      const target = focusOf(place);
      target.scrollIntoView({ block: 'center' });
      target.focus();
    } }, text));
  });
  summary.hidden = errors.length === 0;
  summary.replaceChildren(h('h2', {}, headline(errors)), h('ul', {}, ...lines));
}
