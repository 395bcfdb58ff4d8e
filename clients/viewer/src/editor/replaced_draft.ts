// SPDX-License-Identifier: MIT
// Drafts whose place copies of jobs took: offered, the newest first and over reloads too, until they are brought back or
// dismissed.
import type { JsonObject } from '../scene/field';
import { button, h } from '../ui/dom';
import { readDrafts, withDraft, withoutNewest, type Draft, type KeptDrafts } from './kept_drafts';

const key = 'slipstitch.replaced';

function stored(): KeptDrafts {
  try {
    return readDrafts(sessionStorage.getItem(key));
  } catch {
    return { drafts: [] };
  }
}

/// As many as there is room for.
function store({ drafts, copy }: KeptDrafts): void {
  try {
    sessionStorage.removeItem(key);
  } catch {
    return;  // storage is forbidden: then they are kept until a reload
  }
  for (let count = drafts.length; count > 0; --count) {
    try {
      return sessionStorage.setItem(key, JSON.stringify({ drafts: drafts.slice(0, count), copy }));
    } catch {
      // Too large: then without the oldest.
    }
  }
}

export interface ReplacedDraft {
  element: HTMLElement;
  /// The draft makes place for the copy.
  replace(draft: Draft, copy: JsonObject): void;
  /// The scene is another one now; it may be a draft again, by Undo.
  changed(scene: JsonObject): void;
}

export function replacedDraft(bringBack: (draft: Draft) => void): ReplacedDraft {
  const state = { kept: stored() };
  const element = h('p', { class: 'links replaced', role: 'status', hidden: true });
  const set = (kept: KeptDrafts): void => {
    state.kept = kept;
    store(kept);
    show();
  };
  const dismiss = (): void => set(withoutNewest(state.kept));
  const restore = (): void => {
    const [newest] = state.kept.drafts;
    dismiss();
    bringBack(newest);
  };
  function show(): void {
    const { drafts } = state.kept;
    element.hidden = drafts.length === 0;
    element.replaceChildren(...(drafts.length > 0 ? ['A copy took the place of the scene that was edited here. ',
      button('Bring that back', restore, { class: 'small' }), button('Dismiss', dismiss, { class: 'small' }),
      drafts.length > 1 ? `Then ${drafts.length === 2 ? 'an older one is' : `${drafts.length - 1} older ones are`} offered.` : ''] : []));
  }
  show();
  return {
    element,
    replace: (draft, copy) => set(withDraft(state.kept, draft, copy)),
    changed: (scene) => {
      const { drafts, copy } = state.kept;
      if (drafts.some((draft) => draft.scene === scene)) set({ drafts: drafts.filter((draft) => draft.scene !== scene), copy });
    },
  };
}
