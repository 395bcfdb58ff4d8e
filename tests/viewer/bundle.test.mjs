// SPDX-License-Identifier: MIT
// What a browser loads: small, and from nowhere else.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { viewer } from './support.mjs';

const files = readdirSync(viewer, { recursive: true }).map((name) => join(viewer, name)).filter((path) => statSync(path).isFile());
const limit = 1_000_000;

test('the compressed bundle is below 1 MB', () => {
  assert.ok(files.some((path) => path.endsWith('index.html')) && files.some((path) => path.endsWith('.js')), `no viewer in ${viewer}`);
  const size = files.reduce((sum, path) => sum + gzipSync(readFileSync(path)).length, 0);
  assert.ok(size < limit, `${size} bytes`);
});

test('the page has no inline script or style', () => {
  const html = readFileSync(join(viewer, 'index.html'), 'utf8');
  assert.doesNotMatch(html, /<style|style=|\son\w+=|javascript:|<script(?![^>]*\ssrc=)/);
  assert.doesNotMatch(html, /https?:/);
});
