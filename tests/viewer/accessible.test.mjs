// SPDX-License-Identifier: MIT
// axe finds nothing, in light and dark, on a desk and on a phone; nothing sticks out of a narrow page.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { axePath, endlessScene, openPage, pictureFacts, shoot, smallScene, startBrowser, startServer, submit, swing, untilEnded, untilPlotted, untilState } from './support.mjs';

const axe = readFileSync(axePath, 'utf8');
const bodies = { colliders: { colliders: [{ sphere: { centre_m: [0.008, -0.012, -0.006], radius_m: 0.006 } }] } };
let server, browser, id, study, running;
before(async () => {
  server = await startServer();
  browser = await startBrowser();
  id = await submit(server.address, { ...smallScene, name: 'on a ball', effects: { ...smallScene.effects, ...bodies } });
  assert.equal((await untilEnded(server.address, id)).state, 'SUCCEEDED');
  study = await submit(server.address, swing, { study: { quick: true } });
  assert.equal((await untilEnded(server.address, study)).state, 'SUCCEEDED');
  await untilEnded(server.address, await submit(server.address, { ...smallScene, name: 'W'.repeat(180), duration_s: 0.05 }));
});
after(async () => {
  await browser?.close();
  await server?.stop();
});

async function violations(page) {
  await page.evaluate(axe);
  const results = await page.evaluate(() => axe.run(document, { resultTypes: ['violations'] }));
  return results.violations.map((found) => `${found.id}: ${found.nodes.map((node) => `${node.target} ${node.failureSummary}`).join(' | ')}`);
}

const pages = [
  ['editor', '#/new', async (page) => {
    await page.getByRole('combobox', { name: 'Start from' }).selectOption('ball-drop');
    await page.waitForFunction(() => document.querySelector('#field-name').value === 'ball-drop');
    for (const details of await page.locator('details').all()) await details.evaluate((element) => { element.open = true; });
  }],
  ['jobs', '#/jobs', (page) => page.getByText('on a ball').waitFor()],
  ['job', () => `#/jobs/${id}`, async (page) => {
    await page.locator('canvas.stage[data-drawn]').waitFor();
    await untilState(page, 'Done');
    await untilPlotted(page, smallScene.duration_s);
    await page.getByLabel('Colour by').selectOption('slid');
    await page.getByRole('button', { name: 'Show' }).click();
  }],
  ['estimate', '#/new', async (page) => {
    await page.locator('.estimate > summary').getByText(/unknowns · about \d+ MB · about/).waitFor();
    await page.locator('.estimate > summary').click();
    await page.locator('.estimate dt').first().waitFor();
  }],
  ['order', () => `#/new/${id}`, async (page) => {
    await page.waitForURL(/#\/new$/);
    await page.locator('#field-name').fill('to be replaced');
    await page.locator('#field-name').press('Enter');
    await page.evaluate((copy) => { location.hash = `#/new/${copy}`; }, id);
    await page.getByText('A copy took the place').waitFor();
    await page.getByLabel('Work', { exact: true }).selectOption('study');
    for (const label of ['Budget in s', 'Threads']) {
      await page.getByLabel(label).fill('-1');
      await page.getByLabel(label).press('Enter');
    }
    await page.getByText('This job has 2 problems').waitFor();
  }],
  ['running', async () => `#/jobs/${running = await submit(server.address, endlessScene)}`, async (page) => {
    await page.locator('canvas.stage[data-drawn]').waitFor();
    await page.getByRole('group', { name: 'Time goes to' }).waitFor();
  }],
  ['study', () => `#/jobs/${study}`, (page) => page.locator('.study-report img').nth(1).waitFor()],
];
const looks = [
  ['light', { colorScheme: 'light' }],
  ['dark', { colorScheme: 'dark' }],
  ['landscape', { colorScheme: 'dark', viewport: { width: 844, height: 390 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 }],
  ['phone', { colorScheme: 'light', viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 }],
];

for (const [look, options] of looks) {
  for (const [name, address, prepare] of pages) {
    test(`${name}, ${look}`, async () => {
      const { page, faults, close } = await openPage(browser, options);
      await page.goto(`${server.address}/${typeof address === 'string' ? address : await address()}`);
      await prepare(page);
      assert.deepEqual(await violations(page), []);
      const [wide, room] = await page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
      assert.ok(wide <= room, `the page is ${wide} px wide on ${room} px`);
      const frame = await page.evaluate(() => [...document.querySelectorAll('.table-frame')].map((box) => [box.scrollWidth, box.clientWidth]));
      for (const [inside, box] of frame) assert.ok(inside <= box, `the table is ${inside} px wide in ${box} px`);
      if (name === 'job') assert.ok((await pictureFacts(page)).covered > 0.02, 'the picture is empty');
      // A phone's page of all fields is longer than a picture can be.
      await shoot(page, `${name}-${look}`, { fullPage: !(name === 'editor' && ['phone', 'landscape'].includes(look)) });
      assert.deepEqual(faults, []);
      await close();
      if (name === 'running') await fetch(`${server.address}/v1/simJobs/${running}:cancel`, { method: 'POST' });
    });
  }
}

test('the theme can be chosen and stays', async () => {
  const { page, close } = await openPage(browser, { colorScheme: 'light' });
  await page.goto(server.address);
  await page.getByLabel('Theme').selectOption('dark');
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), 'rgb(20, 24, 28)');
  await page.reload();
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), 'dark');
  await close();
});

test('everything on the page of a job is reached by keys', async () => {
  const { page, close } = await openPage(browser);
  await page.goto(`${server.address}/#/jobs/${id}`);
  await page.locator('canvas.stage[data-drawn]').waitFor();
  await page.locator('canvas.stage').focus();
  const drawn = Number(await page.locator('canvas.stage').getAttribute('data-drawn'));
  await page.keyboard.press('ArrowLeft');
  await page.waitForFunction((before) => Number(document.querySelector('canvas.stage').dataset.drawn) > before, drawn);
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement.textContent), 'Fit');
  await close();
});

test('on a phone on its side the player is in sight, and a finger on the picture scrolls or turns it', async () => {
  const [, options] = looks.find(([look]) => look === 'landscape');
  const { page, close } = await openPage(browser, options);
  await page.goto(`${server.address}/#/jobs/${id}`);
  const canvas = page.locator('canvas.stage[data-drawn]');
  await canvas.waitFor();
  await untilState(page, 'Done');
  await shoot(page, 'job-landscape-first');
  const play = await page.getByRole('button', { name: 'Play' }).boundingBox();
  assert.ok(play.y + play.height <= 390, `Play ends at ${play.y + play.height} px of 390`);
  const box = await canvas.boundingBox();
  const finger = await page.context().newCDPSession(page);
  const [x, y] = [box.x + box.width / 2, 370];
  const swipe = async (dx, dy) => {
    await finger.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [{ x, y }] });
    for (let step = 1; step <= 10; ++step) {
      await finger.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: [{ x: x + (dx * step) / 10, y: y + (dy * step) / 10 }] });
    }
    await finger.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  };
  const drawn = async () => Number(await canvas.getAttribute('data-drawn'));
  const before = await drawn();
  await swipe(120, 0);
  await page.waitForFunction((count) => Number(document.querySelector('canvas.stage').dataset.drawn) > count, before);
  assert.equal(await page.evaluate(() => window.scrollY), 0);
  await swipe(0, -200);
  await page.waitForFunction(() => window.scrollY > 50);
  await close();
});
