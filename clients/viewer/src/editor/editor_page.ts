// SPDX-License-Identifier: MIT
import { fieldErrors, pathAndAncestors, type FieldError } from '../api/field_errors';
import { ApiError } from '../api/api_error';
import { jobId } from '../api/messages';
import { artefactText, createSimJob, getSimJob } from '../api/sim_jobs';
import type { FormContext } from '../form/form_context';
import { emptyFields, showErrors } from '../form/show_errors';
import { textInput } from '../form/simple_fields';
import type { JsonObject } from '../scene/field';
import { isObject } from '../scene/json_path';
import { readScene, sceneText } from '../scene/scene_file';
import { button, h } from '../ui/dom';
import type { Page } from '../ui/page';
import { chartPanel } from './chart_panel';
import { estimate } from './estimate';
import { jsonPanel } from './json_panel';
import { orderFields, orderOf } from './order_fields';
import { replacedDraft } from './replaced_draft';
import { sceneForm, type OpenSections } from './scene_form';
import { sceneMenu } from './scene_menu';
import { SceneModel } from './scene_model';

function newRequestId(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(12));
  return `viewer-${[...bytes].map((byte) => byte.toString(16).padStart(2, '0')).join('')}`;
}

/// `copyOf`: the id of a job whose scene to begin with.
export function editorPage(copyOf?: string): Page {
  const model = new SceneModel();
  const open: OpenSections = new Set(['Knit', 'Effects', 'Holds', 'Time and accuracy']);
  const summary = h('section', { class: 'error-summary', role: 'alert', 'aria-label': 'Problems', tabindex: -1, hidden: true });
  const status = h('p', { class: 'status', role: 'status' });
  const formFrame = h('div', { class: 'form-frame' });
  const besideFrame = h('div', { class: 'form-frame' });
  const nameFrame = h('div', { class: 'name-frame' });
  const fault = h('p', { class: 'error-box', role: 'alert', hidden: true });
  const tell = (text: string, problem: string): void => {
    status.textContent = text;
    fault.textContent = problem;
    fault.hidden = problem === '';
  };
  const say = (text: string): void => tell(text, '');
  const refuse = (errors: readonly FieldError[]): void => {
    say('');
    model.errors.set(errors);
    showAll();
    summary.focus();
    summary.scrollIntoView({ block: 'nearest' });
  };

  /// What is typed and is no value: it is never sent.
  const typed = (): FieldError[] => [...order.problems(), ...[...model.typed].map(([path, message]) => ({ path, message }))];
  const allErrors = (): FieldError[] =>
    [...typed(), ...model.errors.value.filter(({ path }) => path === '' || !typed().some((wrong) => wrong.path === path))];
  const showAll = (): void => showErrors(element, summary, allErrors());
  const context: FormContext = {
    scene: () => model.scene.value,
    set: (path, value, structural) => {
      const around = pathAndAncestors(path);  // an error of a group is about the fields in it
      model.errors.set(model.errors.value.filter((error) => error.path === '' || !(around.includes(error.path) || /^[.[]/.test(error.path.slice(path.length)) && error.path.startsWith(path))));
      model.set(path, value);
      if (structural) drawForm();
      else showAll();
    },
    complain: (path, message) => {
      if (message === undefined) model.typed.delete(path);
      else model.typed.set(path, message);
      if (message !== undefined) {
        say('');
        cost.changed();
      }
      showAll();
    },
  };
  const order = orderFields((label) => {
    model.errors.set(model.errors.value.filter(({ path }) => path !== label));
    say('');
    cost.changed();
    showAll();
  });
  const cost = estimate(() => {
    const wrong = [...allErrors().filter(({ about }) => about !== 'server'), ...emptyFields(element)];
    return order.order().work === 'simulate' && wrong.length === 0 ? sceneText(model.scene.value) : undefined;
  });
  const chart = chartPanel({
    changed: (knit) => context.set('knit', knit, knit === undefined || !isObject(model.scene.value.knit)),
    undo: () => {
      model.undo();
      drawForm();
    },
    complain: context.complain,
  });
  const json = jsonPanel(() => sceneText(model.scene.value), (scene) => load(scene));

  /// Draws all fields anew and puts the focus back on the one that had it.
  function drawForm(): void {
    const focused = document.activeElement;
    const key = focused instanceof HTMLElement && element.contains(focused) ? focused.id || focused.dataset.focus : undefined;
    for (const path of [...model.typed.keys()]) if (!chart.typed.includes(path)) model.typed.delete(path);  // the text goes with its field
    const form = sceneForm(context, open);
    formFrame.replaceChildren(form.main);
    besideFrame.replaceChildren(form.beside);
    nameFrame.replaceChildren(textInput(context, 'Name of the scene', 'for people', 'name'));
    showAll();
    if (key) (document.getElementById(key) ?? element.querySelector<HTMLElement>(`[data-focus="${key}"]`))?.focus();
  }
  function load(scene: JsonObject): void {
    model.replace(scene);
    drawForm();
  }

  const replaced = replacedDraft((draft) => {
    order.show(draft.order);
    load(draft.scene);
  });

  async function send(validateOnly: boolean): Promise<void> {
    if (typed().length > 0) {
      summary.focus();
      return;
    }
    const empty = emptyFields(element);
    if (empty.length > 0) return refuse(empty);
    const sent = model.scene.value;
    const tellCost = validateOnly ? cost.expect() : undefined;
    say(validateOnly ? 'Checking …' : 'Submitting …');
    setBusy(true);
    try {
      const job = await createSimJob(sceneText(sent), { order: order.order(), validateOnly, requestId: validateOnly ? '' : newRequestId() });
      model.errors.set([]);
      showAll();
      tellCost?.(job.prediction);
      say(model.scene.value === sent ? 'The scene can be run.' : 'The scene has changed since it was checked.');
      if (!validateOnly) location.hash = `#/jobs/${jobId(job)}`;
    } catch (error) {
      tellCost?.(undefined);
      refuse(error instanceof ApiError ? fieldErrors(error) : [{ path: '', message: String(error), about: 'server' }]);
    } finally {
      setBusy(false);
    }
  }
  const submit = button('Submit', () => void send(false), { class: 'primary', 'data-action': 'submit' });
  const check = button('Check', () => void send(true), { 'data-action': 'check' });
  function setBusy(busy: boolean): void {
    submit.disabled = check.disabled = busy;
  }
  const menu = sceneMenu({ load, text: () => sceneText(model.scene.value), name: () => String(model.scene.value.name ?? 'scene'),
    fail: (problem) => {
      model.errors.set([]);  // or they would seem to be about what was not loaded
      showAll();
      tell('', problem);
    } });
  const element = h('div', { class: 'page editor-page' },
    h('div', { class: 'page-head' }, h('h1', {}, 'New job'), menu, h('span', { class: 'push' }), ...order.elements, check, submit), status, replaced.element, fault, summary,
    h('div', { class: 'editor-columns' },
      h('div', { class: 'left' }, nameFrame, h('section', { class: 'panel', 'aria-label': 'Chart' }, h('h2', {}, 'Chart'), chart.element), besideFrame, json.element),
      formFrame), cost.element);
  const left = { now: false };
  const stop = model.scene.subscribe((scene) => {
    replaced.changed(scene);
    cost.changed();
    chart.show(scene);
    json.show();
    say('');  // what was said was about another scene
  });
  drawForm();
  if (copyOf !== undefined) {
    Promise.all([artefactText(copyOf, 'scene.json'), getSimJob(copyOf)]).then(([text, job]) => {
      if (left.now) return;
      const scene = readScene(text);
      const hadDraft = model.isDraft;
      const before = { scene: model.scene.value, order: order.order() };
      load(isObject(scene.scene) ? scene.scene : scene);
      order.show(orderOf(job));
      history.replaceState(null, '', '#/new');  // a reload, and Back from the new job, lead to the draft: not to the copy anew
      if (hadDraft) replaced.replace(before, model.scene.value);
    }).catch((error: unknown) => tell('', `The scene of ${copyOf} cannot be read: ${error instanceof Error ? error.message : String(error)}`));
  }
  return {
    title: 'New job',
    element,
    leave: () => {
      left.now = true;
      stop();
      cost.leave();
      chart.leave();
    },
  };
}
