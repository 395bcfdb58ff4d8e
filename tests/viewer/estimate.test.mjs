// SPDX-License-Identifier: MIT
// What a run would take is told before it is ordered, and asked for sparingly.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openPage, shoot, smallScene, startBrowser, startServer } from './support.mjs';

let server, browser, view;
const asked = [];   // requests to the server, each with how it is answered
before(async () => {
  server = await startServer();
  browser = await startBrowser();
  view = await openPage(browser);
  const { page } = view;
  await page.clock.install();
  await page.route('**/v1/simJobs', (route) => {
    asked.push({ route, ...JSON.parse(route.request().postData()) });
  });
  await page.goto(server.address);
  await page.clock.pauseAt(Date.now() + 3600_000);  // from here on time passes by runFor alone
  await untilAsked(page, 1);  // about the scene it began with
  asked.length = 0;
});
after(async () => {
  await browser?.close();
  await server?.stop();
});

const line = (page) => page.locator('.estimate > summary');
/// Where the chart begins, in px from the top of the page: a click must hit the stitch that it is meant for.
const topOfChart = (page) => page.evaluate(() => document.querySelector('canvas.chart').getBoundingClientRect().top + scrollY);
let top;
const prediction = (unknowns) => ({ unknowns, memory_bytes: '40400000', as_it_is: { wall_s: 12.4, steps: '30', basis: 'WHOLE_RUN' } });
const answer = ({ route }, json) => route.fulfill({ json: { state: 'QUEUED', ...json } });

async function untilAsked(page, count) {
  while (asked.length < count) await page.waitForTimeout(20);
}

/// All that the page has asked until now is known: requests come in order.
const askedAll = (page) => page.evaluate(async () => void await fetch('icon.svg'));

async function type(page, label, text) {
  await page.getByLabel(label).fill(text);
  await page.getByLabel(label).press('Enter');
}

test('a pause after the last change asks once, and the real answer is shown with what it rests on', async () => {
  const { page, faults } = view;
  await page.getByText('Scene as JSON').click();
  await page.getByLabel('Scene as JSON').fill(JSON.stringify(smallScene));
  await page.getByRole('button', { name: 'Use this JSON' }).click();
  for (const duration of ['0.3', '0.4', '0.2']) {
    await type(page, 'Duration s', duration);
    await page.clock.runFor(900);
  }
  await askedAll(page);
  assert.deepEqual(asked, []);
  assert.equal(await line(page).isVisible(), false);
  top = await topOfChart(page);
  await page.clock.runFor(1000);
  await untilAsked(page, 1);
  assert.deepEqual([asked[0].validate_only, asked[0].spec.simulate, asked[0].spec.scene.duration_s], [true, {}, 0.2]);
  await asked[0].route.continue();
  await line(page).getByText(/^722 unknowns · about \d+ MB · about [\d.]+ s$/).waitFor();
  const scrolled = await page.evaluate(() => scrollY);
  await line(page).click();
  const told = page.locator('.estimate');
  assert.deepEqual(await told.locator('dt').allTextContents(), ['As it is', 'To 1 mm', 'To 0.1 mm', 'To 0.01 mm']);
  await told.getByText(/tried by the server/).waitFor();
  assert.deepEqual([await topOfChart(page), await page.evaluate(() => scrollY)], [top, scrolled], 'the chart has moved');
  await shoot(page, 'estimate');
  await page.clock.runFor(60_000);
  await askedAll(page);
  assert.equal(asked.length, 1, 'nothing changed');
  assert.deepEqual(faults, []);
});

test('an answer about a scene that has changed since is left', async () => {
  const { page } = view;
  asked.length = 0;
  await type(page, 'Duration s', '0.5');
  await line(page).getByText(/^722 unknowns .* · estimating anew …$/).waitFor();
  const told = page.locator('.estimate');
  assert.deepEqual([await told.getAttribute('aria-busy'), await told.locator('dt').count()], ['true', 4], 'what was told stays until it is told anew');
  assert.equal(await topOfChart(page), top, 'the chart has moved');
  await page.clock.runFor(2000);
  await untilAsked(page, 1);
  await type(page, 'Duration s', '0.6');
  await answer(asked[0], { prediction: prediction(111) }).catch(() => undefined);  // the page no longer waits for it
  await page.clock.runFor(2000);
  await untilAsked(page, 2);
  assert.match(await line(page).textContent(), /^722 unknowns .* · estimating anew …$/);
  await answer(asked[1], { prediction: prediction(222) });
  await line(page).getByText(/^222 unknowns · about 40 MB · about 12 s$/).waitFor();
  assert.deepEqual([await told.getAttribute('aria-busy'), await told.locator('dt').count()], ['false', 1]);
});

test('the answer to Check tells it too; without a prediction, and after a refusal, nothing is there', async () => {
  const { page } = view;
  asked.length = 0;
  const check = async (reply) => {
    const count = asked.length;
    await page.getByRole('button', { name: 'Check' }).click();
    await untilAsked(page, count + 1);
    await reply(asked[count]);
  };
  await check((request) => answer(request, { prediction: { ...prediction(333), run_fails: 'no step is short enough' } }));
  await line(page).getByText('333 unknowns · about 40 MB · fails at its start').waitFor();
  await page.getByText('A run ends at its start: no step is short enough').waitFor();
  assert.equal(await topOfChart(page), top, 'the chart has moved');
  await shoot(page, 'estimate-fails');
  await check((request) => answer(request, { prediction: { ...prediction(355), chooses_effects: true } }));
  await line(page).getByText('about 12 s and the choice of effects before it').waitFor();
  await page.getByText(/with and without effects, which can take longer than the run/).waitFor();
  await check((request) => answer(request, {}));
  await page.locator('.estimate').waitFor({ state: 'hidden' });
  assert.equal(await topOfChart(page), top, 'the chart has moved');
  await check((request) => answer(request, { prediction: prediction(444) }));
  await line(page).getByText('444 unknowns').waitFor();
  await check(({ route }) => route.fulfill({ status: 400, json: { code: 3, message: 'no', details: [] } }));
  await page.locator('.estimate').waitFor({ state: 'hidden' });
});

test('nothing is asked for a study, for what is no value, or from another page', async () => {
  const { page, faults, close } = view;
  asked.length = 0;
  await page.getByLabel('Work', { exact: true }).selectOption('study');
  await page.clock.runFor(5000);
  await page.getByLabel('Work', { exact: true }).selectOption('simulate');
  await type(page, 'Threads', '-1');
  await page.clock.runFor(5000);
  await type(page, 'Threads', '');
  await type(page, 'Duration s', 'soon');
  await page.clock.runFor(5000);
  await type(page, 'Duration s', '0.1');
  await page.getByRole('link', { name: 'Jobs' }).click();
  await page.getByRole('heading', { name: 'Jobs' }).waitFor();
  await page.clock.runFor(5000);
  await askedAll(page);
  assert.deepEqual(asked.flatMap(({ spec }) => (spec ? [spec] : [])), []);
  assert.deepEqual(faults, []);
  await close();
});
