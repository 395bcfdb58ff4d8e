// SPDX-License-Identifier: MIT
// A list of jobs longer than a page.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { endlessScene, openPage, startBrowser, startServer, submit } from './support.mjs';

const ended = 55;
let server, browser, running, waiting;
const cancel = (id) => fetch(`${server.address}/v1/simJobs/${id}:cancel`, { method: 'POST' });
before(async () => {
  server = await startServer(['--slots', '1']);
  browser = await startBrowser();
  running = await submit(server.address, { ...endlessScene, name: 'oldest' });
  waiting = await submit(server.address, { ...endlessScene, name: 'waiting' });
  for (let index = 0; index < ended; ++index) await cancel(await submit(server.address, { ...endlessScene, name: `number ${index}` }));
});
after(async () => {
  await browser?.close();
  await server?.stop();
});

test('rows of older pages are kept up to date, cancelled and deleted', async () => {
  const { page, faults, close } = await openPage(browser);
  page.on('dialog', (dialog) => void dialog.accept());
  const rows = page.locator('tbody tr');
  const row = (name) => rows.filter({ has: page.getByRole('link', { name, exact: true }) });
  const untilRows = (count) => page.waitForFunction((wanted) => document.querySelectorAll('tbody tr').length === wanted, count);
  await page.goto(`${server.address}/#/jobs`);
  await untilRows(50);
  await page.getByRole('button', { name: 'Older jobs' }).click();
  await untilRows(ended + 2);
  assert.equal(await page.getByRole('button', { name: 'Older jobs' }).isVisible(), false);
  await row('waiting').getByText('Queued').waitFor();
  const at = () => page.evaluate(() => document.activeElement.getAttribute('aria-label') ?? document.activeElement.tagName);
  assert.equal(await at(), 'A', 'where the older jobs begin, as their button is gone');

  await row('oldest').getByRole('button').focus();
  const before = await row('oldest').innerText();
  await page.waitForFunction((text) => ![...document.querySelectorAll('tbody tr')].some((one) => one.innerText === text), before);
  assert.equal(await at(), 'Cancel oldest', 'after its row was drawn anew');
  await row('number 3').getByRole('button').focus();
  await page.keyboard.press('Enter');
  await row('number 3').waitFor({ state: 'detached' });
  assert.equal(await at(), 'Delete number 2', 'the row that came in its place');
  await submit(server.address, { ...endlessScene, name: 'number 3' }).then(cancel);
  await untilRows(ended + 2);

  await row('waiting').getByRole('button', { name: 'Cancel' }).click();
  await row('waiting').getByText('Cancelled').waitFor();
  await row('waiting').getByRole('button', { name: 'Delete' }).click();
  await row('waiting').waitFor({ state: 'detached' });
  assert.equal((await fetch(`${server.address}/v1/simJobs/${waiting}`)).status, 404);
  assert.equal(await rows.count(), ended + 1);

  await cancel(running);  // by another program
  await row('oldest').getByText('Cancelled').waitFor();
  await fetch(`${server.address}/v1/simJobs/${running}`, { method: 'DELETE' });
  await row('oldest').waitFor({ state: 'detached' });
  const fresh = await submit(server.address, { ...endlessScene, name: 'newest' });
  await row('newest').waitFor();
  assert.equal(await rows.count(), ended + 1, 'a new job pushes none out of the list');

  await page.getByLabel('Show').selectOption('QUEUED');
  await page.getByText('No jobs here yet.').waitFor();
  await page.getByLabel('Show').selectOption('');
  await untilRows(50);
  await cancel(fresh);
  assert.deepEqual(faults, []);
  await close();
});
