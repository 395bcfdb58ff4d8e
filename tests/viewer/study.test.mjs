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
  await page.getByLabel('Work', { exact: true }).selectOption('quick study');
  await page.getByRole('button', { name: 'Submit' }).click();
  await page.waitForURL(/#\/jobs\//);
  await untilState(page, 'Queued');
  const id = page.url().replace(/.*\//, '');
  assert.deepEqual((await getJob(server.address, id)).study, { quick: true, budget_s: 0 });
  assert.equal(await page.textContent('.job-work'), 'Quick study');

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
  await page.unroute(address);
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
