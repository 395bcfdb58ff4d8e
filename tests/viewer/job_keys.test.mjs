// SPDX-License-Identifier: MIT
// Keys, fingers and pointers on the page of a job, and what it offers.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openPage, pictureFacts, shoot, smallScene, startBrowser, startServer, submit, untilEnded, untilState } from './support.mjs';

let server, browser, id;
before(async () => {
  server = await startServer();
  browser = await startBrowser();
  id = await submit(server.address, { ...smallScene, name: 'short', duration_s: 0.05, frames_per_s: 100 });
  assert.equal((await untilEnded(server.address, id)).state, 'SUCCEEDED');
});
after(async () => {
  await browser?.close();
  await server?.stop();
});

async function openJob(options) {
  const view = await openPage(browser, options);
  await view.page.goto(`${server.address}/#/jobs/${id}`);
  await view.page.locator('canvas.stage[data-drawn]').waitFor();
  await untilState(view.page, 'Done');
  await view.page.locator('svg.plot').first().waitFor();
  return view;
}

test('space belongs to what has the focus', async () => {
  const { page, faults, close } = await openJob();
  const play = () => page.locator('[data-action="play"]').textContent();
  await page.getByLabel('Speed').selectOption('0.05');
  const box = page.getByLabel('energies as change');
  await box.focus();
  await page.keyboard.press(' ');
  assert.equal(await box.isChecked(), false);
  assert.equal(await play(), 'Play');
  for (const other of [page.getByLabel('Colour by'), page.getByRole('link', { name: 'Download as CSV' }), page.getByLabel('Course of the stitch')]) {
    await other.focus();
    await page.keyboard.press(' ');
    assert.equal(await play(), 'Play');
    await page.keyboard.press('Escape');
  }
  await page.locator('canvas.stage').focus();
  await page.keyboard.press(' ');
  assert.equal(await play(), 'Pause');
  assert.deepEqual(faults, []);
  await close();
});

/// Waits for the next picture after `act`.
async function drawnAfter(page, act) {
  const before = Number(await page.locator('canvas.stage').getAttribute('data-drawn'));
  await act();
  await page.waitForFunction((count) => Number(document.querySelector('canvas.stage').dataset.drawn) > count, before);
}

/// Where the yarn is in the picture, in px, and how large.
async function yarn(page) {
  await page.evaluate(() => document.activeElement.blur());  // the ring of the focus is no yarn
  const { box: [left, top, right, bottom] } = await pictureFacts(page);
  return { x: (left + right) / 2, y: (top + bottom) / 2, width: right - left, height: bottom - top };
}

function assertMoved(before, after, dx, dy, what) {
  const [x, y] = [after.x - before.x, after.y - before.y];
  assert.ok(Math.abs(x - dx) < 12 && Math.abs(y - dy) < 12, `${what} moved the fabric by ${x}, ${y} px, expected ${dx}, ${dy}`);
  assertSameSize(before, after, what);
}

/// But for perspective, and for fingers, which are told of one after the other and so zoom a little on the way.
function assertSameSize(before, after, what) {
  const same = Math.abs(after.width / before.width - 1) < 0.06 && Math.abs(after.height / before.height - 1) < 0.06;
  assert.ok(same, `${what} turned it: ${JSON.stringify([before, after])}`);
}

const drags = [
  ['the right button', {}, { button: 'right' }],
  ['Ctrl and the left button', { key: 'Control' }, { button: 'left' }],
];
for (const [what, { key }, button] of drags) {
  test(`${what} moves the fabric`, async () => {
    const { page, close } = await openJob();
    await drawnAfter(page, () => page.getByRole('button', { name: 'Front' }).click());
    const before = await yarn(page);
    const { x, y, width, height } = await page.locator('canvas.stage').boundingBox();
    const [cx, cy] = [x + width / 2, y + height / 2];
    await page.mouse.move(cx, cy);
    if (key) await page.keyboard.down(key);
    await page.mouse.down(button);
    await drawnAfter(page, () => page.mouse.move(cx + 60, cy + 20, { steps: 4 }));
    await page.mouse.up(button);
    if (key) await page.keyboard.up(key);
    assertMoved(before, await yarn(page), 60, 20, what);
    await close();
  });
}

test('Shift and arrow keys move the fabric, and the picture says so', async () => {
  const { page, close } = await openJob();
  const canvas = page.locator('canvas.stage');
  assert.match(await canvas.getAttribute('aria-label'), /with Shift they move it/);
  await drawnAfter(page, () => page.getByRole('button', { name: 'Front' }).click());
  const before = await yarn(page);
  const step = (await canvas.boundingBox()).height / 20;
  for (const key of ['Shift+ArrowRight', 'Shift+ArrowRight', 'Shift+ArrowDown']) await drawnAfter(page, () => canvas.press(key));
  assertMoved(before, await yarn(page), 2 * step, step, 'Shift and arrow keys');
  for (const key of ['Shift+ArrowLeft', 'Shift+ArrowLeft', 'Shift+ArrowUp']) await drawnAfter(page, () => canvas.press(key));
  assertMoved(before, await yarn(page), 0, 0, 'there and back');
  await close();
});

test('two fingers that go the same way move the fabric', async () => {
  const { page, close } = await openJob({ hasTouch: true });
  await drawnAfter(page, () => page.getByRole('button', { name: 'Front' }).click());
  const before = await yarn(page);
  const { x, y, width, height } = await page.locator('canvas.stage').boundingBox();
  const touch = await page.context().newCDPSession(page);
  const fingers = (dx, dy) => [-40, 40].map((apart, index) => ({ x: x + width / 2 + apart + dx, y: y + height / 2 + dy, id: index }));
  await touch.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: fingers(0, 0) });
  await drawnAfter(page, async () => {
    for (let step = 1; step <= 12; ++step) await touch.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: fingers(10 * step, 2 * step) });
  });
  await touch.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  const after = await yarn(page);
  assert.ok(after.x - before.x > 80, `moved by ${after.x - before.x} px of 120`);
  assertSameSize(before, after, 'two fingers');
  await shoot(page, 'job-moved');
  await close();
});

test('no label of a plot is cut off', async () => {
  const { page, close } = await openJob();
  const cut = await page.locator('svg.plot').evaluateAll((plots) => plots.flatMap((plot) => [...plot.querySelectorAll('.tick')].filter((tick) => {
    const [{ x, width }, view] = [tick.getBBox(), plot.viewBox.baseVal];
    return x < view.x || x + width > view.x + view.width;
  }).map((tick) => tick.textContent)));
  assert.deepEqual(cut, []);
  await close();
});

test('of a job that is not there only the error and the way to the others is shown', async () => {
  const { page, faults, close } = await openPage(browser);
  await page.goto(`${server.address}/#/jobs/nope`);
  await page.getByRole('link', { name: 'All jobs' }).waitFor();
  assert.match(await page.textContent('.error-box:visible'), /nope/);
  assert.deepEqual(await page.locator('main').locator('a, button, input, select, canvas, progress').evaluateAll((found) => found.map((element) => element.outerHTML)),
    [await page.getByRole('link', { name: 'All jobs' }).evaluate((link) => link.outerHTML)]);
  assert.equal(await page.getByText('Waiting for the first frame').count(), 0);
  await shoot(page, 'job-missing');
  await page.getByRole('link', { name: 'All jobs' }).click();
  await page.getByRole('link', { name: 'short', exact: true }).waitFor();
  assert.deepEqual(faults, []);
  await close();
});
