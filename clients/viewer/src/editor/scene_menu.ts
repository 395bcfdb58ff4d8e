// SPDX-License-Identifier: MIT
import { examples } from '../scene/examples';
import type { JsonObject } from '../scene/field';
import { freshScene, readScene } from '../scene/scene_file';
import { button, h } from '../ui/dom';
import { saveFile } from '../ui/download';

export interface SceneMenuSink {
  load(scene: JsonObject): void;
  text(): string;
  name(): string;
  fail(text: string): void;
}

/// Examples, and scene files from and to the person's disk.
export function sceneMenu(sink: SceneMenuSink): HTMLElement {
  const box = h('select', { id: 'example', 'aria-label': 'Start from' }, h('option', { value: '' }, 'Start from …'), h('option', { value: 'fresh' }, 'a new swatch'),
    ...examples.map((example) => h('option', { value: example.name }, example.name)));
  box.addEventListener('change', () => {
    const example = examples.find((candidate) => candidate.name === box.value);
    if (box.value === 'fresh') sink.load(freshScene());
    example?.load().then((scene) => sink.load(structuredClone(scene)), () => sink.fail('The example cannot be loaded.'));
    box.value = '';
  });
  const file = h('input', { type: 'file', accept: '.json,application/json', hidden: true, 'aria-label': 'Scene file' });
  file.addEventListener('change', () => {
    const chosen = file.files?.[0];
    file.value = '';
    chosen?.text().then((text) => sink.load(readScene(text))).catch((error: unknown) =>
      sink.fail(`${chosen.name} was not loaded: ${error instanceof Error ? error.message : String(error)}. The scene is as it was.`));
  });
  const save = (): void => saveFile(`${sink.name().replace(/[^\w.-]+/g, '-') || 'scene'}.json`, new Blob([sink.text()], { type: 'application/json' }));
  return h('span', { class: 'pair' }, box, button('Load file', () => file.click()), file, button('Save file', save));
}
