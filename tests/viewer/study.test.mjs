// SPDX-License-Identifier: MIT
// A study: ordered in the editor, watched, and its report seen.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { getJob, openPage, shoot, startBrowser, startServer, submit, swing, untilProgress, untilState } from './support.mjs';

let server, browser, view;
before(async () => {
  server = await startServer(['--slots', '1']);
  browser = await startBrowser();
  view = await openPage(browser);
});
after(async () => {
  await browser?.close();
  await server?.stop();
});

test('a study is a choice beside Submit', async () => {
  const { page } = view;
  const long = await submit(server.address, { ...swing, name: 'long', duration_s: 1000 }, { study: {} });  // the next one waits for it
  await page.goto(server.address);
  const budget = page.getByLabel('Budget in s');
  assert.equal(await budget.isVisible(), false, 'a simulation has none');
  await page.getByLabel('Work', { exact: true }).selectOption('quick study');
  await budget.fill('-1');
  await page.getByRole('button', { name: 'Submit' }).click();
  await page.getByRole('alert', { name: 'Problems' }).getByText('Budget in s is -1, expected a finite number >= 0').waitFor();
  await budget.fill('77.5');
  await page.getByLabel('Threads').fill('2');
  await page.getByRole('button', { name: 'Submit' }).click();
  await page.waitForURL(/#\/jobs\//);
  await untilState(page, 'Queued');
  const id = page.url().replace(/.*\//, '');
  const { study, threads } = await getJob(server.address, id);
  assert.deepEqual([study, threads], [{ quick: true, budget_s: 77.5 }, 2]);
  assert.equal(await page.textContent('.job-work'), 'Quick study');
  await page.evaluate(() => sessionStorage.clear());
  await page.getByRole('link', { name: 'Edit a copy' }).click();
  await page.waitForURL(/#\/new$/);
  const asked = async () => [await page.getByLabel('Work', { exact: true }).inputValue(), await budget.inputValue(), await page.getByLabel('Threads').inputValue()];
  assert.deepEqual(await asked(), ['quick study', '77.5', '2']);
  await page.reload();
  assert.deepEqual(await asked(), ['quick study', '77.5', '2']);

  await page.goto(`${server.address}/#/jobs/${long}`);
  await untilProgress(page, /^\d+ % · \S.* · (time left not known yet|.* left)$/);
  assert.equal(await page.locator('canvas.stage').count(), 0, 'no player');
  await page.getByText('The scene is run in many ways').waitFor();
  await page.getByRole('button', { name: 'Cancel' }).click();
  await untilState(page, 'Cancelled');
  await page.getByText('This study has no report.').waitFor();
  await fetch(`${server.address}/v1/simJobs/${id}:cancel`, { method: 'POST' });
});

test('its page shows plots and leads to the report, which runs no scripts', async () => {
  const { page, faults } = view;
  const id = await submit(server.address, swing, { study: { quick: true } });
  await page.goto(`${server.address}/#/jobs/${id}`);
  await untilState(page, 'Done');
  const plots = page.locator('.study-report img');
  await plots.nth(1).waitFor();
  await page.waitForFunction(() => [...document.querySelectorAll('.study-report img')].every((image) => image.complete && image.naturalWidth > 100));
  assert.equal(await plots.count(), 2);
  await page.getByText('One more digit costs').waitFor();
  assert.match(await page.textContent('.files'), /study\.csv/);
  await shoot(page, 'study', { fullPage: true });

  const open = async () => {
    const opened = page.waitForEvent('popup');
    await page.getByRole('link', { name: 'Open the report' }).click();
    const report = await opened;
    report.on('console', (message) => faults.push(message.text()));
    await report.waitForLoadState();
    return report;
  };
  const report = await open();
  assert.equal(await report.textContent('h1'), 'swing: accuracy against time');
  assert.equal(await report.locator('svg').count(), 2);
  assert.equal(await report.evaluate(() => getComputedStyle(document.body).maxWidth), '1200px', 'its own style is let in');
  await report.reload();
  assert.deepEqual(faults, []);
  await report.close();

  const file = join(server.data, 'jobs', id, 'report', 'study.html');
  writeFileSync(file, '<!doctype html><h1>as it was</h1><script>document.querySelector("h1").textContent = "changed";</script>');
  const forged = await open();
  assert.equal(await forged.textContent('h1'), 'as it was');
  await forged.close();
  faults.length = 0;  // the policy stopped that
});

test('its report is asked for until there is an answer', async () => {
  const { page, faults } = view;
  const { jobs } = await (await fetch(`${server.address}/v1/simJobs`)).json();
  const id = jobs.find((job) => job.scene_name === 'swing').name.replace(/.*\//, '');
  const files = `${server.address}/v1/simJobs/${id}/artefacts`;
  const asked = { times: 0 };
  await page.goto(`${server.address}/#/jobs`);
  await page.route(files, (route) => {
    asked.times += 1;
    return asked.times < 3 ? route.abort() : route.continue();
  });
  const said = page.locator('[aria-label="Study"] .note');
  await page.goto(`${server.address}/#/jobs/${id}`);
  await said.getByText('Asking for the report …').waitFor();
  await page.getByRole('link', { name: 'Open the report' }).waitFor();
  assert.ok(asked.times >= 3, String(asked.times));
  await page.unroute(files);
  assert.deepEqual(faults, []);
});

test('one that compared nothing has no empty plots, and is a study again when copied', async () => {
  const { page, faults } = view;
  const id = (await fetch(`${server.address}/v1/simJobs`).then((answer) => answer.json())).jobs.find((job) => job.scene_name === 'swing').name.replace(/.*\//, '');
  const address = `${server.address}/v1/simJobs/${id}`;
  await page.goto(`${server.address}/#/jobs`);
  await page.route(address, async (route) => {
    const answer = await route.fetch();
    const job = await answer.json();
    const summary = JSON.parse(job.summary_json);
    for (const rung of summary.study.rungs) rung.position_error_m = null;  // as where there was no time for a reference
    await route.fulfill({ response: answer, json: { ...job, summary_json: JSON.stringify(summary) } });
  });
  await page.goto(`${server.address}/#/jobs/${id}`);
  await page.getByText('No way to run the scene could be compared with another').waitFor();
  await page.getByRole('link', { name: 'Open the report' }).waitFor();
  assert.equal(await page.locator('.study-report img').count(), 0);
  await page.getByRole('link', { name: 'Edit a copy' }).click();
  await page.waitForFunction(() => [...document.querySelectorAll('select')].some((box) => box.value === 'quick study'));
  await page.unrouteAll({ behavior: 'wait' });  // an answer may be on its way
  assert.deepEqual(faults, []);
});

test('the list names it', async () => {
  const { page, faults, close } = view;
  await page.goto(`${server.address}/#/jobs`);
  const row = page.locator('tbody tr', { has: page.getByRole('link', { name: 'swing', exact: true }) });
  await row.getByText('Quick study').waitFor();
  page.once('dialog', (dialog) => {
    assert.match(dialog.message(), /its report/);
    void dialog.accept();
  });
  await row.getByRole('button', { name: 'Delete' }).click();
  await row.waitFor({ state: 'detached' });
  assert.deepEqual(faults, []);
  await close();
});
