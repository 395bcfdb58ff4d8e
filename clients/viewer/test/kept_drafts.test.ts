// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { readDrafts, withDraft, withoutNewest, type Draft, type KeptDrafts } from '../src/editor/kept_drafts';

const draft = (name: string): Draft => ({ scene: { name }, order: { work: 'simulate' } });
const none: KeptDrafts = { drafts: [] };
const names = ({ drafts }: KeptDrafts): unknown[] => drafts.map(({ scene }) => scene.name);
/// Each draft in turn makes place for the copy after it.
const after = (...steps: [string, string][]): KeptDrafts =>
  steps.reduce((kept, [scene, copy]) => withDraft(kept, draft(scene), { name: copy }), none);

describe('drafts whose place copies took', () => {
  it('are offered one after the other, the newest first', () => {
    const kept = after(['A', 'copy of 1'], ['edited copy', 'copy of 2']);
    expect(names(kept)).toEqual(['edited copy', 'A']);
    expect(names(withoutNewest(kept))).toEqual(['A']);
    expect(names(withoutNewest(withoutNewest(kept)))).toEqual([]);
  });
  it('are not mere copies, nor what is edited now, and each is there once', () => {
    expect(names(after(['A', '1'], ['1', '2']))).toEqual(['A']);
    expect(names(after(['A', '1'], ['B', 'A']))).toEqual(['B']);
    expect(names(after(['A', '1'], ['B', '2'], ['A', '3']))).toEqual(['A', 'B']);
    expect(names(after(['A', 'A']))).toEqual([]);
  });
  it('go, the oldest first, where they are many', () => {
    expect(names(after(['A', '1'], ['B', '2'], ['C', '3'], ['D', '4']))).toEqual(['D', 'C', 'B']);
  });
  it('come back from a page that was left, and only what is known', () => {
    const kept = after(['A', '1'], ['B', '2']);
    expect(readDrafts(JSON.stringify(kept))).toEqual(kept);
    for (const text of [null, 'null', '{}', '3', '{"scene":{},"copy":{}}']) expect(names(readDrafts(text))).toEqual([]);
  });
});
