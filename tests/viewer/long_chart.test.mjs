// SPDX-License-Identifier: MIT
// Charts larger than the window: the cursor stays in sight, and a stitch costs what a stitch is worth.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openPage, shoot, smallScene, startBrowser, startServer } from './support.mjs';

let server, browser;
before(async () => {
  server = await startServer();
  browser = await startBrowser();
});
after(async () => {
  await browser?.close();
  await server?.stop();
});

const withRows = (rows) => ({ ...smallScene, knit: { ...smallScene.knit, chart: { rows } } });

async function openChart(rows, options = {}) {
  const view = await openPage(browser, options);
  await view.page.addInitScript(() => {
    window.marks = 0;
    for (const name of ['fillRect', 'rect', 'arc', 'lineTo', 'fillText']) {
      const draw = CanvasRenderingContext2D.prototype[name];
      CanvasRenderingContext2D.prototype[name] = function counted(...numbers) {
        window.marks += 1;
        return draw.apply(this, numbers);
      };
    }
  });
  await view.page.goto(server.address);
  await view.page.getByText('Scene as JSON').click();
  await view.page.getByLabel('Scene as JSON').fill(JSON.stringify(withRows(rows)));
  await view.page.getByRole('button', { name: 'Use this JSON' }).click();
  await view.page.waitForFunction((courses) => document.querySelector('canvas.chart').dataset.courses === String(courses), rows.length);
  await view.page.getByText('Scene as JSON').click();  // closed: it would be written anew with every stitch
  return view;
}

/// Whether all of a cell is within the window and the frame that scrolls.
const isInSight = ([row, column]) => {
  const canvas = document.querySelector('canvas.chart');
  const [box, frame, { cell, left }] = [canvas.getBoundingClientRect(), canvas.closest('.chart-frame').getBoundingClientRect(), canvas.dataset];
  const [x, y] = [box.left + Number(left) + column * cell, box.top + 2 + row * cell];
  return x >= Math.max(frame.left, 0) && y >= Math.max(frame.top, 0) && x + Number(cell) <= Math.min(frame.right, innerWidth) && y + Number(cell) <= Math.min(frame.bottom, innerHeight);
};
const untilInSight = (page, row, column) => page.waitForFunction(isInSight, [row, column]);

test('the stitch that keys change is in sight', async () => {
  const { page, faults, close } = await openChart(Array(40).fill('K'.repeat(10)));
  const canvas = page.locator('canvas.chart');
  await page.getByText('Copy rows').focus();
  await page.evaluate(() => window.scrollTo(0, 0));
  await canvas.focus();
  await untilInSight(page, 39, 0);
  await canvas.press('p');
  assert.ok(await page.evaluate(isInSight, [39, 1]));
  await shoot(page, 'chart-long');
  for (let row = 39; row > 0; --row) await canvas.press('ArrowUp');
  assert.ok(await page.evaluate(isInSight, [0, 1]));
  await canvas.evaluate((element) => { element.closest('.chart-frame').scrollTop = 1e4; });
  assert.equal(await page.evaluate(isInSight, [0, 1]), false);
  await canvas.press(' ');
  assert.ok(await page.evaluate(isInSight, [0, 1]));
  assert.deepEqual(faults, []);
  await close();
});

test('a click on a long chart changes the stitch under the pointer and scrolls nothing', async () => {
  const { page, close } = await openChart(Array(40).fill('K'.repeat(10)));
  const canvas = page.locator('canvas.chart');
  await page.evaluate(() => window.scrollTo(0, 0));
  const { x, y } = await canvas.boundingBox();
  const { cell, left } = await canvas.evaluate((element) => ({ ...element.dataset }));
  await page.mouse.click(x + Number(left) + 3.5 * cell, y + 2 + 4.5 * cell);
  assert.equal((await canvas.boundingBox()).y, y);
  const rows = await page.evaluate(() => document.querySelector('textarea[aria-label^="Chart as rows"]').value.split('\n'));
  assert.equal(rows[4], 'KKKPKKKKKK');
  await close();
});

test('one stitch of a large chart draws a few rows, not all of them', async () => {
  const seed = Array.from({ length: 400 }, (_, row) => Array.from({ length: 400 }, (_, column) => ((row + column) % 2 ? 'P' : 'K')).join(''));
  const { page, close } = await openChart(seed);
  const canvas = page.locator('canvas.chart');
  await canvas.focus();
  for (const key of ['k', 'p', 'ArrowUp', ' ']) {
    await page.evaluate(() => { window.marks = 0; });
    await canvas.press(key);
    const marks = await page.evaluate(() => window.marks);
    assert.ok(marks < 400 * 40, `${key} drew ${marks} shapes for a chart of 160000 stitches`);
  }
  await close();
});

for (const deviceScaleFactor of [1, 1.5]) {
  test(`what is drawn bit by bit looks as if drawn at once, at ${deviceScaleFactor} device pixels a pixel`, async () => {
    const { page, close } = await openChart(Array(9).fill('KPKPKKKK'), { deviceScaleFactor });
    const canvas = page.locator('canvas.chart');
    const pixels = async () => {
      await page.getByLabel('Name of the scene').focus();
      return page.evaluate(() => {
        const { width, height } = document.querySelector('canvas.chart');
        return [...document.querySelector('canvas.chart').getContext('2d').getImageData(0, 0, width, height).data];
      });
    };
    await canvas.focus();
    const blank = await pixels();
    await canvas.focus();
    for (const key of ['p', 'p', 'ArrowUp', 'End', ' ', 'Shift+ArrowUp', 'Shift+ArrowUp', 'p', 'ArrowUp', 'ArrowUp', 'ArrowUp', 'ArrowUp', 'ArrowUp', 'ArrowUp', 'p', 'Home', 'p']) await canvas.press(key);
    for (let row = 0; row < 9; ++row) await canvas.press('ArrowDown');
    await canvas.press('Home');
    const drawn = await pixels();
    const difference = (a, b) => a.reduce((most, value, index) => Math.max(most, Math.abs(value - b[index])), 0);
    assert.ok(difference(drawn, blank) > 50);
    await page.reload();  // the draft is kept, and its chart drawn anew
    await page.waitForFunction(() => document.querySelector('canvas.chart').dataset.courses === '9');
    assert.ok(difference(await pixels(), drawn) <= 2, 'beyond how blended edges are rounded');
    await close();
  });
}
