// SPDX-License-Identifier: MIT
// Drafts whose place copies of jobs took.
import type { Order } from '../api/sim_jobs';
import type { JsonObject } from '../scene/field';
import { isSame } from '../scene/json_path';

export interface Draft {
  scene: JsonObject;
  order: Order;
}

export interface KeptDrafts {
  drafts: readonly Draft[];  // the newest first
  copy?: JsonObject;  // what took the place of the newest
}

const mostDrafts = 3;

/// The draft makes place for the copy.
export function withDraft(kept: KeptDrafts, { scene, order }: Draft, copy: JsonObject): KeptDrafts {
  const isMereCopy = kept.copy !== undefined && isSame(kept.copy, scene);  // nobody made it
  const older = kept.drafts.filter((draft) => !isSame(draft.scene, scene));
  const drafts = isMereCopy ? kept.drafts : [{ scene, order }, ...older];
  return { drafts: drafts.filter((draft) => !isSame(draft.scene, copy)).slice(0, mostDrafts), copy };
}

export function withoutNewest({ drafts, copy }: KeptDrafts): KeptDrafts {
  return { drafts: drafts.slice(1), copy };
}

/// Of text that sessionStorage had; whatever else it is, it has none.
export function readDrafts(text: string | null): KeptDrafts {
  const found = JSON.parse(text ?? 'null') as KeptDrafts | null;
  return found && Array.isArray(found.drafts) ? found : { drafts: [] };
}
