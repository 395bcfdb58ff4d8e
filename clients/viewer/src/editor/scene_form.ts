// SPDX-License-Identifier: MIT
import { effectSwitches } from '../form/effect_switches';
import { fieldForm, groupFields } from '../form/field_form';
import { fieldId, type FormContext } from '../form/form_context';
import { crossings, guides, handles, initialVelocities, loads, yarns } from '../scene/geometry_fields';
import { knitField, numericsField, timeFields, yarnField } from '../scene/scene_fields';
import { h, type Child } from '../ui/dom';

/// Sections that a person has opened, kept while the form is drawn anew.
export type OpenSections = Set<string>;

/// `path`: of the message that the section shows.
function section(open: OpenSections, title: string, path: string | undefined, ...children: Child[]): HTMLElement {
  const error = path !== undefined && h('p', { class: 'field-error', id: `${fieldId(path)}-error`, hidden: true });
  const details = h('details', { class: 'section', open: open.has(title), 'data-path': path, id: path && fieldId(path), tabindex: path && -1 },
    h('summary', {}, h('h2', {}, title)), error, ...children);
  details.addEventListener('toggle', () => (details.open ? open.add(title) : open.delete(title)));
  return details;
}

export interface SceneForm {
  beside: HTMLElement;  // under the chart
  main: HTMLElement;
}

export function sceneForm(context: FormContext, open: OpenSections): SceneForm {
  const hasKnit = context.scene().knit !== undefined;  // of whatever type: its problems have a place
  const beside = h('div', { class: 'sections' },
    hasKnit && section(open, 'Knit', undefined, ...groupFields(context, knitField, 'knit', ['chart', 'preset', 'worked_rows'])),
    section(open, 'Yarn', 'yarn', ...groupFields(context, yarnField, 'yarn')),
    section(open, 'Time and accuracy', undefined, ...groupFields(context, timeFields, ''), ...groupFields(context, numericsField, '')));
  const main = h('div', { class: 'sections' },
    section(open, 'Effects', undefined, effectSwitches(context)),
    section(open, 'Holds', undefined, fieldForm(context, handles, 'handles')),
    section(open, 'Loads and velocities', undefined, fieldForm(context, loads, 'loads'), fieldForm(context, initialVelocities, 'initial_velocities')),
    section(open, 'Bare yarns', undefined, fieldForm(context, yarns, 'yarns'), fieldForm(context, guides, 'guides'), fieldForm(context, crossings, 'crossings')));
  return { beside, main };
}
