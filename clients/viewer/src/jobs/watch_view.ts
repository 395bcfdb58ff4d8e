// SPDX-License-Identifier: MIT
// Picture, legend and player of a job. One place decides what is shown: `refresh`.
import type { Fabric, Frame } from '../fabric/fabric';
import { quantityOf, rangeOf, valuesOfVisits } from '../fabric/quantities';
import { FabricView } from '../draw/fabric_view';
import { legend, type ColourChoice } from '../draw/legend';
import type { ViewName } from '../draw/stage';
import { hasEnded } from '../api/messages';
import { playerBar } from '../player/player_bar';
import { Player } from '../player/player';
import { button, h, keepsKey } from '../ui/dom';
import type { JobModel } from './job_model';

export interface WatchSink {
  frame(frame: Frame): void;
  picked(stitch: number): void;
}

export interface WatchView {
  element: HTMLElement;
  choose(stitch: number): void;
  picture(): Promise<Blob>;
  leave(): void;
}

const views: readonly [ViewName, string][] = [['angled', 'Fit'], ['front', 'Front'], ['back', 'Back'], ['side', 'Side'], ['top', 'Top']];
const yarnColours: readonly [string, string][] = [['#d9b98a', 'oat'], ['#7fa8c9', 'sky'], ['#b5544d', 'brick'], ['#7d9a6b', 'moss']];

export function watchView(model: JobModel, sink: WatchSink): WatchView {
  const player = new Player(model.store);
  const choice: ColourChoice = { name: 'none', range: undefined };
  const drawing: { view?: FabricView; request: number; last: number; refresh: number; shown: readonly unknown[] } =
    { request: 0, last: 0, refresh: 0, shown: [] };
  const canvas = h('canvas', { class: 'stage', tabindex: 0, role: 'img',
    'aria-label': 'The fabric in three dimensions. Arrow keys turn it, with Shift they move it; plus and minus zoom, space plays.' });
  const message = h('p', { class: 'stage-message', role: 'status' }, 'Waiting for the first frame …');
  const colours = legend(choice, () => refresh());
  const bar = playerBar(player, model.store, () => refresh());

  /// With the next picture of the screen, however much comes until then; never while the window is hidden.
  const refreshSoon = (): void => {
    if (drawing.refresh === 0) drawing.refresh = requestAnimationFrame(() => refresh());
  };
  const refresh = (): void => {
    cancelAnimationFrame(drawing.refresh);
    drawing.refresh = 0;
    const fabric = model.fabric.value;
    const frame = model.store.at(player.place);
    bar.update(!model.gone.value && (!hasEnded(model.job.value?.state) || !model.streamEnded.value), fabric?.numFrames ?? 0);
    if (!frame && model.streamEnded.value) message.textContent = 'This job has no frames.';
    if (!fabric || !frame) return;
    openView(fabric, frame);
    showFrame(fabric, frame);
    if (player.playing && drawing.request === 0) {
      drawing.last = performance.now();
      drawing.request = requestAnimationFrame(tick);
    }
  };

  function showFrame(fabric: Fabric, frame: Frame): void {
    const wanted = [frame, choice.name, choice.range];
    if (wanted.every((part, index) => part === drawing.shown[index])) return;
    drawing.shown = wanted;
    const quantity = quantityOf(choice.name);
    const values = valuesOfVisits(choice.name, fabric, frame, model.store.first ?? frame);
    const range = choice.range ?? rangeOf(values, quantity.diverging, quantity.least);
    colours.show(range);
    drawing.view?.show(frame, { values, range, diverging: quantity.diverging, on: choice.name !== 'none' });
    canvas.dataset.frame = String(frame.index);
    sink.frame(frame);
  }

  function tick(now: number): void {
    drawing.request = 0;
    const changed = player.advance((now - drawing.last) / 1000);
    drawing.last = now;
    if (changed) refresh();
    if (player.playing && drawing.request === 0) drawing.request = requestAnimationFrame(tick);
  }

  function openView(fabric: Fabric, frame: Frame): void {
    if (drawing.view || message.dataset.failed) return;
    try {
      drawing.view = new FabricView(canvas, fabric, model.store.first ?? frame);
      message.hidden = true;
      if (model.scene.value !== undefined) drawing.view.setScene(model.scene.value);
    } catch (error) {
      message.dataset.failed = 'true';
      message.textContent = `This browser cannot draw the fabric: ${error instanceof Error ? error.message : String(error)}`;
    }
  }

  const turn = (event: KeyboardEvent): boolean => {
    const [step, part] = [0.12, 0.05];  // rad, of the picture's height
    const pans: Record<string, [number, number]> = { ArrowLeft: [-part, 0], ArrowRight: [part, 0], ArrowUp: [0, part], ArrowDown: [0, -part] };
    if (event.shiftKey && event.key in pans) {
      drawing.view?.pan(...pans[event.key]);
      return true;
    }
    const moves: Record<string, [number, number, number]> = {
      ArrowLeft: [-step, 0, 1], ArrowRight: [step, 0, 1], ArrowUp: [0, -step, 1], ArrowDown: [0, step, 1],
      '+': [0, 0, 0.9], '=': [0, 0, 0.9], '-': [0, 0, 1.1],
    };
    if (!(event.key in moves)) return false;
    drawing.view?.orbit(...moves[event.key]);
    return true;
  };
  canvas.addEventListener('keydown', (event) => {
    if (turn(event)) event.preventDefault();
  });
  const onKey = (event: KeyboardEvent): void => {
    if (keepsKey(event.target, event.key) || event.ctrlKey || event.metaKey || event.altKey) return;
    const actions: Record<string, () => void> = {
      ' ': () => (player.playing ? player.pause() : player.play()),
      ',': () => player.step(-1), '.': () => player.step(1), l: () => player.follow(),
    };
    if (!(event.key in actions)) return;
    event.preventDefault();
    actions[event.key]();
    refresh();
  };
  document.addEventListener('keydown', onKey);

  const pressed = { x: 0, y: 0 };
  canvas.addEventListener('pointerdown', (event) => Object.assign(pressed, { x: event.clientX, y: event.clientY }));
  canvas.addEventListener('click', (event) => {
    if (Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) > 4) return;  // it was a turn
    const visit = drawing.view?.visitAt(event.clientX, event.clientY) ?? -1;
    sink.picked(visit < 0 ? -1 : model.fabric.value?.stitchOfVisit[visit] ?? -1);
  });

  const stops = [
    model.frames.subscribe(() => {
      player.framesCame();
      refreshSoon();
    }),
    model.job.subscribe(refreshSoon),
    model.streamEnded.subscribe(refreshSoon),
    model.scene.subscribe((scene) => {
      if (scene !== undefined) drawing.view?.setScene(scene);
    }),
  ];
  const swatches = yarnColours.map(([colour, name]) => {
    const dot = h('span', { class: 'dot', 'aria-hidden': 'true' });
    dot.style.background = colour;
    const choose = button('', () => drawing.view?.setYarnColour(colour), { class: 'dot-button', 'aria-label': `Yarn colour: ${name}`, title: name });
    choose.append(dot);
    return choose;
  });
  const tools = h('div', { class: 'stage-tools', role: 'group', 'aria-label': 'View' },
    ...views.map(([view, text]) => button(text, () => drawing.view?.look(view))), h('span', { class: 'push' }), ...swatches,
    h('p', { class: 'note touch-hint' }, 'One finger that sets out sideways turns and tilts it; two move and zoom.'));
  const element = h('section', { class: 'watch', 'aria-label': 'Fabric' },
    h('div', { class: 'stage-frame' }, canvas, message), tools, bar.element, colours.element);
  return {
    element,
    choose: (stitch) => drawing.view?.mark(stitch),
    picture: () => drawing.view?.picture() ?? Promise.reject(new Error('there is no picture yet')),
    leave: () => {
      cancelAnimationFrame(drawing.request);
      cancelAnimationFrame(drawing.refresh);
      document.removeEventListener('keydown', onKey);
      for (const stop of stops) stop();
      drawing.view?.dispose();
    },
  };
}
