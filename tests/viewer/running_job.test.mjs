// SPDX-License-Identifier: MIT
// A job that runs: reload, lost connection, cancel, list, delete.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { endlessScene, framesMade, getJob, openPage, pictureFacts, shoot, startBrowser, startServer, submit, untilFrame, untilPlotted, untilProgress, untilState } from './support.mjs';
import { startWire } from './wire.mjs';

let server, browser, view, id;
before(async () => {
  server = await startServer(['--slots', '1']);
  browser = await startBrowser();
  view = await openPage(browser);
  id = await submit(server.address, endlessScene);
});
after(async () => {
  await browser?.close();
  await server?.stop();
});

/// Where its picture begins, in px from the top of the page.
const topOfPicture = (page) => page.evaluate(() => document.querySelector('.job-columns').getBoundingClientRect().top + scrollY);
let top;

test('it is followed live with progress', async () => {
  const { page } = view;
  await page.route(`**/v1/simJobs/${id}`, async (route) => {
    const job = await (await route.fetch()).json();
    delete job.progress?.wall_by_phase_s;
    await route.fulfill({ json: job });
  });
  await page.goto(`${server.address}/#/jobs/${id}`);
  await untilFrame(page, 3);
  await untilState(page, 'Running');
  top = await topOfPicture(page);
  await page.unrouteAll({ behavior: 'wait' });
  await untilProgress(page, /of 1000 s · frame \d+ of 100000 · .*(left|time left)/);  // asked for apart from the frames
  assert.equal(await page.getByRole('button', { name: 'Live' }).getAttribute('aria-pressed'), 'true');
});

test('it tells where its time goes, in shares of all of it', async () => {
  const { page } = view;
  const shares = page.getByRole('group', { name: 'Time goes to' });
  await shares.getByText(/^factorisation \d+ %$/).waitFor();
  const texts = await shares.locator('li:not(.time-title)').allTextContents();
  const sum = texts.map((text) => Number(/ (\d+) %$/.exec(text)[1])).reduce((a, b) => a + b);
  assert.ok(Math.abs(sum - 100) <= texts.length, texts.join());
  assert.equal(await shares.locator('.time-part').count(), texts.length);
  const { progress } = await getJob(server.address, id);
  assert.ok(Object.keys(progress.wall_by_phase_s).length >= texts.length - 1);
  assert.equal(await topOfPicture(page), top, 'the picture has moved');
});

test('it fills a picture that was narrow for a while', async () => {
  const { page } = view;
  const { box: [left, , right] } = await pictureFacts(page);
  const narrowed = Number(await page.locator('canvas.stage').getAttribute('data-frame'));
  await page.setViewportSize({ width: 60, height: 900 });
  await untilFrame(page, narrowed + 2);
  await page.setViewportSize({ width: 1280, height: 900 });
  const widened = Number(await page.locator('canvas.stage').getAttribute('data-frame'));
  await untilFrame(page, widened + 2);
  const { box: [newLeft, , newRight] } = await pictureFacts(page);
  // Fabric that falls gets narrower by itself meanwhile; a camera that was left far away shows a sixteenth.
  assert.ok(newRight - newLeft > 0.3 * (right - left), `${newRight - newLeft} px of ${right - left}`);
});

test('a reload in the middle takes it up again, from the first frame on', async () => {
  const { page } = view;
  await page.reload();
  const before = await framesMade(server.address, id);
  await untilFrame(page, before + 2);
  await untilState(page, 'Running');
  await page.getByRole('slider', { name: 'Frame' }).fill('0');
  assert.match(await page.textContent('.frame-place'), /^frame 0 of 100000, 0 s$/);
  await page.getByRole('button', { name: 'Live' }).click();
  await shoot(page, 'job-running');
});

test('head, player and plots move together, though the job tells of nothing new', async () => {
  const { page, faults, close } = await openPage(browser);
  await page.goto(`${server.address}/#/jobs/${id}`);
  await untilFrame(page, 3);
  const job = await getJob(server.address, id);
  await page.route(`**/v1/simJobs/${id}`, (route) => route.fulfill({ json: job }));
  const wanted = job.progress.frames + 40;
  await untilFrame(page, wanted);
  const [head, player] = await page.evaluate(() => ['.progress-text', '.frame-place'].map((place) =>
    /frame \d+ of 100000/.exec(document.querySelector(place).textContent)?.[0]));
  assert.equal(head, player);
  await untilPlotted(page, wanted / endlessScene.frames_per_s);
  await shoot(page, 'job-together', { fullPage: true });
  assert.deepEqual(faults, []);
  await close();
});

test('its files are there while it runs, and fetching all frames can be stopped', async () => {
  const { page } = view;
  await page.locator('.files a', { hasText: 'history.csv' }).waitFor();
  await page.getByRole('link', { name: 'Download as CSV' }).waitFor();
  const held = [];
  await page.route('**/frames/*', (route) => void held.push(route));
  const download = page.getByRole('button', { name: 'Download zip' });
  await download.click();
  const stop = page.getByRole('button', { name: 'Stop the download' });
  await stop.waitFor();
  assert.equal(await download.isDisabled(), true);
  while (held.length < 3) await page.waitForRequest('**/frames/*');
  await shoot(page, 'job-zip', { fullPage: true });
  await stop.click();
  await page.getByText('Stopped.').waitFor();
  assert.equal(await download.isDisabled(), false);
  assert.equal(await stop.isVisible(), false);
  assert.equal(held.length, 3, 'no more was asked for');
  await page.unroute('**/frames/*');
});

test('a job that has not begun offers no history', async () => {
  const waiting = await submit(server.address, { ...endlessScene, name: 'waiting' });
  const { page, close } = await openPage(browser);
  await page.goto(`${server.address}/#/jobs/${waiting}`);
  await untilState(page, 'Queued');
  await page.locator('.files a', { hasText: 'scene.json' }).waitFor();
  assert.equal(await page.getByText('Download as CSV').isVisible(), false);
  await close();
  await fetch(`${server.address}/v1/simJobs/${waiting}:cancel`, { method: 'POST' });
});

test('a cut wire is said, and mended without a hole in the frames', async () => {
  const wire = await startWire(server.address);
  const { page, close } = await openPage(browser);
  await page.goto(`${wire.address}/#/jobs/${id}`);
  await untilFrame(page, 3);
  wire.cut();
  await page.getByText(/trying again/).waitFor();
  const before = await framesMade(server.address, id);
  wire.mend();
  await untilFrame(page, before + 2);
  await page.waitForFunction(() => !/trying again/.test(document.body.textContent));
  const [last, shown] = await page.evaluate(() => [document.querySelector('input[aria-label="Frame"]').max, document.querySelector('canvas.stage').dataset.frame]);
  assert.equal(last, shown, 'as many frames as the last one says');
  await close();
  await wire.stop();
});

test('cancel stops it and keeps its frames', async () => {
  const { page } = view;
  await page.getByRole('button', { name: 'Cancel' }).click();
  await untilState(page, 'Cancelled');
  const { progress } = await getJob(server.address, id);
  await page.waitForFunction((last) => document.querySelector('input[aria-label="Frame"]').max === String(last), progress.frames - 1);
  await page.getByRole('slider', { name: 'Frame' }).fill('1');
  assert.match(await page.textContent('.frame-place'), /^frame 1 of/);
  await page.getByRole('button', { name: 'Live' }).waitFor({ state: 'hidden' });
  await page.getByRole('region', { name: 'Run' }).getByRole('group', { name: 'Time went to' }).waitFor();
  assert.equal(await page.getByRole('group', { name: 'Time goes to' }).count(), 0);
  assert.equal(await topOfPicture(page), top, 'the picture has moved');
});

test('of frames that come at once only the last is worked out, and nothing is drawn anew that is as it was', async () => {
  const { page, close } = await openPage(browser);
  await page.addInitScript(() => {
    window.worked = 0;
    new MutationObserver((changes) => {
      window.worked += changes.filter(({ target, addedNodes }) => target.className === 'frame-place' && addedNodes.length > 0).length;
    }).observe(document, { childList: true, subtree: true });
  });
  await page.goto(`${server.address}/#/jobs/${id}`);
  await untilState(page, 'Cancelled');
  const { progress: { frames } } = await getJob(server.address, id);
  await untilFrame(page, frames - 1);
  const painted = () => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(
    { worked: window.worked, drawn: Number(document.querySelector('canvas.stage').dataset.drawn) })))));
  const { worked, drawn } = await painted();
  assert.ok(worked <= drawn + 2 && drawn < frames, `${worked} of ${frames} frames were worked out for ${drawn} pictures`);
  const asked = (response) => response.url().endsWith(`/v1/simJobs/${id}`);
  await page.waitForResponse(asked);
  await page.waitForResponse(asked);
  assert.equal((await painted()).drawn, drawn, 'drawn anew though nothing changed');
  await close();
});

test('the list shows jobs with their state, cancels and deletes them', async () => {
  const { page, faults } = view;
  const other = await submit(server.address, { ...endlessScene, name: 'other' });
  await page.goto(`${server.address}/#/jobs`);
  const row = (name) => page.locator('tbody tr', { hasText: name });
  await row('other').getByText('Running').waitFor();
  await row('endless').getByText('Cancelled').waitFor();
  await shoot(page, 'jobs');
  await row('other').getByRole('button', { name: 'Cancel' }).click();
  await row('other').getByText('Cancelled').waitFor();
  page.on('dialog', (dialog) => void dialog.accept());
  await row('other').getByRole('button', { name: 'Delete' }).click();
  await row('other').waitFor({ state: 'detached' });
  assert.equal((await fetch(`${server.address}/v1/simJobs/${other}`)).status, 404);
  await page.getByLabel('Show').selectOption('RUNNING');
  await page.getByText('No jobs here yet.').waitFor();
  assert.deepEqual(faults, []);
});

test('a job that was deleted elsewhere is said to be gone, with no links that lead nowhere', async () => {
  const { page, faults, close } = await openPage(browser);
  await page.goto(`${server.address}/#/jobs/${id}`);
  await untilState(page, 'Cancelled');
  await untilFrame(page, 1);
  await page.getByRole('link', { name: 'Download as CSV' }).waitFor();
  assert.equal((await fetch(`${server.address}/v1/simJobs/${id}`, { method: 'DELETE' })).status, 200);
  await untilState(page, 'Deleted');
  await page.locator('.error-box', { hasText: 'This job was deleted' }).waitFor();
  assert.deepEqual(await page.locator('.job-page a:visible').evaluateAll((links) => links.map((link) => link.href)), []);
  assert.equal(await page.getByRole('button', { name: 'Delete' }).isVisible(), false);
  await page.getByRole('slider', { name: 'Frame' }).fill('0');
  assert.match(await page.textContent('.frame-place'), /^frame 0 of/);
  await shoot(page, 'job-deleted', { fullPage: true });
  assert.deepEqual(faults, []);
  await close();
});

test('a job that is not there is said to be missing', async () => {
  const { page } = view;
  await page.goto(`${server.address}/#/jobs/nothing`);
  await page.locator('.error-box:visible').waitFor();
  assert.match(await page.textContent('.error-box'), /nothing/);
});

test('of a job that was cancelled while its effects were chosen only what is known is told', async () => {
  const { page, faults, close } = await openPage(browser);
  const chosen = await submit(server.address, { ...endlessScene, name: 'chosen', effects: { auto: {} } });
  await page.goto(`${server.address}/#/jobs/${chosen}`);
  await untilProgress(page, /^choosing the effects/);
  await page.getByText('Plots appear once the run has written its history.').waitFor();
  await page.getByRole('button', { name: 'Cancel' }).click();
  await untilState(page, 'Cancelled');
  await page.getByText('There is nothing to plot: the job ended before its second frame.').waitFor();
  const run = page.getByRole('region', { name: 'Run' });
  await run.getByText('Wall time').waitFor();
  const { progress, summary_json: summary } = await getJob(server.address, chosen);
  assert.equal(JSON.parse(summary).wall_s, progress.wall_s);
  assert.ok(progress.wall_s > 0);
  const names = await run.locator('dt').allTextContents();
  for (const unknown of ['Loops', 'Nodes', 'Unknowns', 'Steps', 'Newton iterations', 'Effects', 'Solver']) assert.ok(!names.includes(unknown), names.join());
  await shoot(page, 'job-cancelled-early', { fullPage: true });
  assert.deepEqual(faults, []);
  await close();
});
