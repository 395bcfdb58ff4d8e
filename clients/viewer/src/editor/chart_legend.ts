// SPDX-License-Identifier: MIT
import { h } from '../ui/dom';

export function chartLegend(): HTMLElement {
  return h('div', { class: 'chart-legend' },
    h('ul', { 'aria-label': 'Symbols' },
      h('li', {}, h('span', { class: 'symbol knit', 'aria-hidden': 'true' }), 'knit on the right side'),
      h('li', {}, h('span', { class: 'symbol purl', 'aria-hidden': 'true' }), 'purl on the right side')),
    h('p', { class: 'note', id: 'chart-keys' },
      'Seen from the right side; course 1 is at the bottom, its number on the side where it begins. Click or drag to change stitches. Arrow keys move, ' +
      'K and P set, space swaps; with Shift, up and down choose rows; Ctrl+C and Ctrl+V copy and paste them, Ctrl+Z undoes.'));
}
