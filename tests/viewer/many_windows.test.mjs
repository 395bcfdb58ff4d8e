// SPDX-License-Identifier: MIT
// Several windows of one browser on one server, which has six connections for all of them.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { endlessScene, framesMade, openPage, shoot, startBrowser, startServer, submit, untilFrame, untilState } from './support.mjs';

let server, browser, id;
before(async () => {
  server = await startServer();
  browser = await startBrowser();
  id = await submit(server.address, endlessScene);
});
after(async () => {
  await browser?.close();
  await server?.stop();
});

const streamOf = (request) => new URL(request.url()).pathname.endsWith('/frames:stream');
const lastFrame = (page) => page.evaluate(() => Number(document.querySelector('input[aria-label="Frame"]').max));

/// Makes the page believe that its window was covered or uncovered: a headless browser shows all.
function setSeen(page, state) {
  return page.evaluate((value) => {
    Object.defineProperty(document, 'visibilityState', { configurable: true, get: () => value });
    document.dispatchEvent(new Event('visibilitychange'));
  }, state);
}

/// Waits until the run has made `count` more frames, however long it takes.
async function untilMoreFrames(count) {
  const made = () => framesMade(server.address, id);
  const wanted = await made() + count;
  while (await made() < wanted) await new Promise((done) => setTimeout(done, 50));
}

test('a hidden window holds no connection and asks nothing; seen again, it goes on where it was', async () => {
  const { page, faults, close } = await openPage(browser);
  const asked = [];
  page.on('request', (request) => asked.push(request));
  await page.goto(`${server.address}/#/jobs/${id}`);
  await untilFrame(page, 3);
  assert.equal(asked.filter(streamOf).length, 1);
  assert.ok(!asked.some((request) => request.url().endsWith('/events')), 'one stream is enough');

  const ended = page.waitForEvent('requestfailed', streamOf);
  await setSeen(page, 'hidden');
  await ended;
  await untilMoreFrames(30);  // what was on its way has come
  const [before, kept] = [asked.length, await lastFrame(page)];
  await untilMoreFrames(150);
  assert.deepEqual(asked.slice(before).map((request) => request.url()), []);

  const again = page.waitForRequest(streamOf);
  await setSeen(page, 'visible');
  assert.equal(new URL((await again).url()).searchParams.get('first_index'), String(kept + 1));
  await untilFrame(page, kept + 2);
  const [last, shown] = await page.evaluate(() => [document.querySelector('input[aria-label="Frame"]').max, document.querySelector('canvas.stage').dataset.frame]);
  assert.equal(last, shown, 'no frame twice, none missing');
  assert.deepEqual(faults, []);
  await close();
});

test('with five windows on a run the last one loads, all get frames, and Cancel is answered', async () => {
  const { page: first, faults, close } = await openPage(browser);
  const pages = [first];
  await first.goto(`${server.address}/#/jobs/${id}`);
  await untilFrame(first, 1);
  while (pages.length < 5) {
    const page = await first.context().newPage();
    page.setDefaultTimeout(120_000);
    pages.push(page);
    await page.goto(`${server.address}/#/jobs/${id}`);
    await untilFrame(page, 1);
  }
  const last = pages[4];
  await last.getByText('Several windows follow runs').waitFor();
  await untilFrame(last, await lastFrame(last) + 1);
  await shoot(last, 'job-crowded');
  await first.getByRole('button', { name: 'Cancel' }).click();
  for (const page of pages) await untilState(page, 'Cancelled');
  await last.getByText('Several windows follow runs').waitFor({ state: 'detached' });
  assert.deepEqual(faults, []);
  await close();
});
