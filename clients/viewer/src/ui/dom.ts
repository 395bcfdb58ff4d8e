// SPDX-License-Identifier: MIT

export type Child = Node | string | undefined | false;
type Props = Record<string, unknown>;

/// An element with attributes, listeners (`onclick: ...`) and children. Undefined and false attributes are left out.
export function h<K extends keyof HTMLElementTagNameMap>(tag: K, props: Props = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(props)) {
    if (value === undefined || value === false) continue;
    if (typeof value === 'function') element.addEventListener(name.replace(/^on/, ''), value as EventListener);
    else element.setAttribute(name, value === true ? '' : String(value));
  }
  append(element, children);
  return element;
}

const svgNamespace = 'http://www.w3.org/2000/svg';

export function svg(tag: string, props: Props = {}, ...children: Child[]): SVGElement {
  const element = document.createElementNS(svgNamespace, tag);
  for (const [name, value] of Object.entries(props)) if (value !== undefined && value !== false) element.setAttribute(name, String(value));
  append(element, children);
  return element;
}

function append(parent: Element, children: readonly Child[]): void {
  parent.append(...children.filter((child): child is Node | string => child !== undefined && child !== false));
}

const ids = { last: 0 };

/// An id that no other element has.
export function freshId(prefix: string): string {
  ids.last += 1;
  return `${prefix}-${ids.last}`;
}

export function button(label: string, onclick: () => void, props: Props = {}): HTMLButtonElement {
  return h('button', { type: 'button', onclick, ...props }, label);
}

/// A labelled select; the answer to a choice is its value.
export function select(label: string, options: readonly (readonly [string, string])[], value: string, onchange: (value: string) => void): HTMLElement {
  const box = h('select', { id: freshId('select') }, ...options.map(([key, text]) => h('option', { value: key, selected: key === value }, text)));
  box.addEventListener('change', () => onchange(box.value));
  return h('span', { class: 'labelled' }, h('label', { for: box.id }, label), box);
}

/// Whether a key means something to what has the focus: all keys where one types, space where it switches, opens or follows.
export function keepsKey(target: EventTarget | null, key: string): boolean {
  if (!(target instanceof HTMLElement)) return false;
  const plain = ['range', 'checkbox', 'radio', 'button', 'submit', 'color', 'file'];
  if (target.isContentEditable || /^(TEXTAREA|SELECT)$/.test(target.tagName) || (target instanceof HTMLInputElement && !plain.includes(target.type))) return true;
  if (target instanceof HTMLInputElement && target.type === 'range') return false;
  return key === ' ' && target.closest('a[href], button, input, summary, label, [role="button"], [role="switch"]') !== null;
}
