// SPDX-License-Identifier: MIT
import type { FieldError } from '../api/field_errors';
import type { Json, JsonObject } from '../scene/field';
import { withValue } from '../scene/json_path';
import { freshScene } from '../scene/scene_file';
import { Signal } from '../ui/signal';

const draftKey = 'slipstitch.draft';
const mostUndo = 100;

function storedDraft(): JsonObject | undefined {
  try {
    const text = sessionStorage.getItem(draftKey);
    return text === null ? undefined : (JSON.parse(text) as JsonObject);
  } catch {
    return undefined;
  }
}

/// The scene that is edited, its past, and what is wrong with it.
export class SceneModel {
  private readonly stored = storedDraft();
  readonly scene = new Signal<JsonObject>(this.stored ?? freshScene());
  readonly errors = new Signal<readonly FieldError[]>([]);
  readonly typed = new Map<string, string>();  // places whose text is no value, with why
  private past: JsonObject[] = [];

  /// Whether somebody made the scene, now or before a reload.
  get isDraft(): boolean {
    return this.stored !== undefined || this.past.length > 0;
  }

  replace(scene: JsonObject): void {
    this.typed.clear();
    this.errors.set([]);
    this.change(scene);
  }

  set(path: string, value: Json | undefined): void {
    this.change(withValue(this.scene.value, path, value));
  }

  undo(): void {
    const before = this.past.pop();
    if (!before) return;
    this.scene.set(before);
    this.keep();
  }

  private change(scene: JsonObject): void {
    this.past = [...this.past.slice(1 - mostUndo), this.scene.value];
    this.scene.set(scene);
    this.keep();
  }

  /// Survives a reload of the page.
  private keep(): void {
    try {
      sessionStorage.setItem(draftKey, JSON.stringify(this.scene.value));
    } catch {
      // Too large, or storage is forbidden: then it does not.
    }
  }
}
