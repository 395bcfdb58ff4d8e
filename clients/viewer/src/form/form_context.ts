// SPDX-License-Identifier: MIT
import type { Json, JsonObject } from '../scene/field';

/// What the parts of a form need of the page around them.
export interface FormContext {
  scene(): JsonObject;
  /// Undefined removes. `structural`: other fields come or go with it, so the form is drawn anew.
  set(path: string, value: Json | undefined, structural: boolean): void;
  /// What was typed at a path is no value (message) or is one again (undefined).
  complain(path: string, message: string | undefined): void;
}

export function fieldId(path: string): string {
  return `field-${path.replace(/[^A-Za-z0-9_]+/g, '-')}`;
}
