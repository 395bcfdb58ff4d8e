// SPDX-License-Identifier: MIT
// The draft whose place a copy of a job took: offered, over reloads too, until it is brought back or dismissed.
import type { Order } from '../api/sim_jobs';
import type { JsonObject } from '../scene/field';
import { isSame } from '../scene/json_path';
import { button, h } from '../ui/dom';

const key = 'slipstitch.replaced';

export interface Draft {
  scene: JsonObject;
  order: Order;
}

interface Replaced extends Draft {
  copy: JsonObject;  // what took its place
}

function stored(): Replaced | undefined {
  try {
    return (JSON.parse(sessionStorage.getItem(key) ?? 'null') as Replaced | null) ?? undefined;
  } catch {
    return undefined;
  }
}

function store(replaced: Replaced | undefined): void {
  try {
    sessionStorage.removeItem(key);  // should the new one be too large
    if (replaced) sessionStorage.setItem(key, JSON.stringify(replaced));
  } catch {
    // Too large, or storage is forbidden: then it is kept until a reload.
  }
}

export interface ReplacedDraft {
  element: HTMLElement;
  /// The draft makes place for the copy.
  replace(draft: Draft, copy: JsonObject): void;
  /// The scene is another one now; it may be the draft again, by Undo.
  changed(scene: JsonObject): void;
}

export function replacedDraft(bringBack: (draft: Draft) => void): ReplacedDraft {
  const state = { replaced: stored() };
  const element = h('p', { class: 'links replaced', role: 'status', hidden: true });
  const set = (replaced: Replaced | undefined): void => {
    state.replaced = replaced;
    store(replaced);
    show();
  };
  const restore = (): void => {
    const { replaced } = state;
    set(undefined);
    if (replaced) bringBack(replaced);
  };
  function show(): void {
    element.hidden = !state.replaced;
    element.replaceChildren(...(state.replaced ? ['A copy took the place of the scene that was edited here. ',
      button('Bring that back', restore, { class: 'small' }), button('Dismiss', () => set(undefined), { class: 'small' })] : []));
  }
  show();
  return {
    element,
    replace: (draft, copy) => {
      if (isSame(draft.scene, copy)) return;
      const { replaced } = state;
      const kept = replaced && isSame(replaced.copy, draft.scene) ? replaced : draft;  // nobody made a draft that is a mere copy
      set(isSame(kept.scene, copy) ? undefined : { scene: kept.scene, order: kept.order, copy });
    },
    changed: (scene) => {
      if (scene === state.replaced?.scene) set(undefined);
    },
  };
}
