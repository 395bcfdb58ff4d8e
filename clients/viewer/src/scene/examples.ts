// SPDX-License-Identifier: MIT
import type { JsonObject } from './field';

const files = import.meta.glob<JsonObject>(['../../../../scenes/*.json', '../../../../scenes/effects/*.json'], { import: 'default' });

export interface Example {
  name: string;
  load(): Promise<JsonObject>;
}

/// The scenes of the repository's folder scenes/, by their path there without ".json".
export const examples: Example[] = Object.entries(files)
  .map(([path, load]) => ({ name: path.replace(/^.*\/scenes\//, '').replace(/\.json$/, ''), load }))
  .sort((a, b) => Number(a.name.includes('/')) - Number(b.name.includes('/')) || a.name.localeCompare(b.name));
