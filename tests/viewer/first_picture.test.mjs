// SPDX-License-Identifier: MIT
// The first picture waits for nothing but the first frame, and that for no step. ./run bench has its time.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { getJob, openPage, pictureFacts, startBrowser, startServer } from './support.mjs';
import { openEditor, submitUntilDrawn, swatchScene } from './swatch.mjs';

let server, browser;
before(async () => {
  server = await startServer();
  browser = await startBrowser();
});
after(async () => {
  await browser?.close();
  await server?.stop();
});

test('a 30×30 job is drawn before the run has come to its second frame', async () => {
  const { page, faults, close } = await openPage(browser);
  await openEditor(page, server.address, swatchScene);
  await submitUntilDrawn(page);
  assert.equal(await page.locator('canvas.stage').getAttribute('data-frame'), '0');
  assert.ok((await pictureFacts(page)).covered > 0.05, 'the picture is empty');
  const { state, progress } = await getJob(server.address, page.url().replace(/^.*\//, ''));
  assert.deepEqual([state, progress?.frames ?? 1], ['RUNNING', 1]);
  assert.deepEqual(faults, []);
  await close();
});
