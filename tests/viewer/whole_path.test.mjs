// SPDX-License-Identifier: MIT
// From drawing a chart to scrubbing its frames.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { getJob, openPage, pictureFacts, shoot, smallScene, startBrowser, startServer, submit, untilPlotted, untilState } from './support.mjs';

let server, browser, view;
before(async () => {
  server = await startServer();
  browser = await startBrowser();
  view = await openPage(browser);
});
after(async () => {
  await browser?.close();
  await server?.stop();
});

const rowsOf = (page) => page.evaluate(() => document.querySelector('textarea[aria-label^="Chart as rows"]').value.split('\n'));

async function cellPlace(page, row, column) {
  const canvas = page.locator('canvas.chart');
  const [box, data] = [await canvas.boundingBox(), await canvas.evaluate((element) => ({ ...element.dataset }))];
  return [box.x + Number(data.left) + (column + 0.5) * Number(data.cell), box.y + 2 + (row + 0.5) * Number(data.cell)];
}

test('a chart is drawn by clicking, dragging and keys', async () => {
  const { page } = view;
  await page.goto(server.address);
  await page.getByLabel('Courses', { exact: true }).fill('6');
  await page.getByLabel('Courses', { exact: true }).press('Enter');
  await page.getByLabel('Wales', { exact: true }).fill('6');
  await page.getByLabel('Wales', { exact: true }).press('Enter');
  assert.deepEqual(await rowsOf(page), Array(6).fill('KKKKKK'));

  await page.mouse.click(...await cellPlace(page, 5, 1));
  assert.equal((await rowsOf(page))[5], 'KPKKKK');
  await page.mouse.move(...await cellPlace(page, 2, 2));
  await page.mouse.down();
  await page.mouse.move(...await cellPlace(page, 2, 4));  // in one leap
  await page.mouse.up();
  assert.equal((await rowsOf(page))[2], 'KKPPPK');

  await page.mouse.click(...await cellPlace(page, 0, 0));
  await page.keyboard.press('k');
  await page.keyboard.press('p');
  assert.equal((await rowsOf(page))[0], 'KPKKKK');
  assert.match(await page.textContent('.chart-status'), /Course 6, wale 3: knit/);
});

test('rows are copied, pasted, undone, repeated and swapped', async () => {
  const { page } = view;
  await page.mouse.click(...await cellPlace(page, 5, 0));
  await page.keyboard.press('k');
  await page.keyboard.press('Shift+ArrowUp');
  await page.keyboard.press('Control+c');
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Control+v');
  assert.deepEqual((await rowsOf(page)).slice(1), ['KKKKKK', 'KPKKKK', 'KKKKKK', 'KKKKKK', 'KPKKKK']);
  await page.keyboard.press('Control+z');
  assert.equal((await rowsOf(page))[2], 'KKPPPK');
  await page.getByRole('button', { name: 'Swap knit and purl' }).click();
  assert.equal((await rowsOf(page))[2], 'PPKKKP');
  await page.getByRole('button', { name: 'Undo' }).click();
  await page.getByRole('button', { name: 'Repeat' }).click();
  assert.equal((await rowsOf(page)).length, 12);
  assert.equal((await rowsOf(page))[2], 'KKPPPKKKPPPK');
  await shoot(page, 'editor', { fullPage: true });
  await page.getByRole('button', { name: 'Undo' }).click();
  assert.equal((await rowsOf(page)).length, 6);
});

test('the scene is set, checked, saved and loaded', async () => {
  const { page } = view;
  await page.getByLabel('Name of the scene').fill('drawn by hand');
  await page.getByLabel('Duration s').fill('0.2');
  await page.getByLabel('Duration s').press('Enter');
  await page.getByRole('button', { name: 'Check' }).click();
  await page.getByText('The scene can be run.').waitFor();
  const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Save file' }).click()]);
  assert.equal(download.suggestedFilename(), 'drawn-by-hand.json');
  const saved = JSON.parse(readFileSync(await download.path(), 'utf8'));
  assert.deepEqual([saved.duration_s, saved.knit.chart.rows], [0.2, await rowsOf(page)]);
  await page.getByRole('combobox', { name: 'Start from' }).selectOption('rib-relax');
  await page.waitForFunction(() => document.querySelector('textarea[aria-label^="Chart as rows"]').value.startsWith('KPKPKP'));
  await page.locator('input[type=file]').setInputFiles({ name: 'a.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(saved)) });
  await page.waitForFunction(() => document.querySelector('#field-name').value === 'drawn by hand');
  assert.deepEqual(await rowsOf(page), saved.knit.chart.rows);
});

test('the job runs, is watched and scrubbed', async () => {
  const { page } = view;
  await page.getByRole('button', { name: 'Submit' }).click();
  await page.waitForURL(/#\/jobs\//);
  await page.locator('canvas.stage[data-drawn]').waitFor();
  await untilState(page, 'Done');
  await page.waitForFunction(() => document.querySelector('input[aria-label="Frame"]').max === '6');
  assert.equal((await page.locator('canvas.stage').getAttribute('data-frame')), '6');
  const id = page.url().replace(/^.*\//, '');
  assert.equal((await getJob(server.address, id)).scene_name, 'drawn by hand');

  const facts = await pictureFacts(page);
  assert.ok(facts.covered > 0.05 && facts.colours > 20, `the picture is empty: ${JSON.stringify(facts)}`);
  await untilPlotted(page, 0.2);
  await shoot(page, 'drawn-job', { fullPage: true });

  const scrubber = page.getByRole('slider', { name: 'Frame' });
  await scrubber.fill('2');
  assert.match(await page.textContent('.frame-place'), /frame 2 of 6, 0\.06667 s/);
  await page.keyboard.press('.');
  assert.match(await page.textContent('.frame-place'), /frame 3 of 6/);
  await page.getByRole('button', { name: 'One frame back' }).click();
  assert.match(await page.textContent('.frame-place'), /frame 2 of 6/);
  await page.getByLabel('Speed').selectOption('0.1');
  await page.getByRole('button', { name: 'Play' }).click();
  await page.waitForFunction(() => /frame 6 of 6/.test(document.querySelector('.frame-place').textContent));
});

test('yarn is coloured with a legend in units, and a stitch tells its numbers', async () => {
  const { page } = view;
  for (const [name, unit] of [['stretch', '%'], ['tension', 'mN'], ['wrap', '°'], ['slid', 'mm']]) {
    await page.getByLabel('Colour by').selectOption(name);
    assert.equal(await page.textContent('.legend .unit'), unit);
    const [low, high] = [await page.getByLabel('Lowest value').inputValue(), await page.getByLabel('Highest value').inputValue()];
    assert.ok(Number(low) < Number(high), `${name} from ${low} to ${high}`);
  }
  await page.getByLabel('keep range').check();
  const kept = await page.getByLabel('Highest value').inputValue();
  await page.getByRole('slider', { name: 'Frame' }).fill('1');
  assert.equal(await page.getByLabel('Highest value').inputValue(), kept);
  await page.getByLabel('Highest value').fill('1001');
  await page.getByLabel('Lowest value').fill('1000');
  await page.getByLabel('Lowest value').press('Enter');
  const { mean: [red, , blue] } = await pictureFacts(page);
  assert.ok(blue > red + 30, `all is below the range, so all is blue: ${red} red, ${blue} blue`);
  await page.getByLabel('Colour by').selectOption('wrap');
  await page.getByLabel('Lowest value').fill('-1001');
  await page.getByLabel('Highest value').fill('-1000');
  await page.getByLabel('Highest value').press('Enter');
  const { reds, blues } = await pictureFacts(page);
  assert.ok(reds > 0.01 && blues === 0, `all is above the range or has no value, so nothing is blue: ${reds} red, ${blues} blue`);
  for (const [low, said] of [['99', 'Lowest value is 99, expected less than the highest value, -1000.'], ['x', 'Lowest value is “x”, expected a number.']]) {
    await page.getByLabel('Lowest value').fill(low);
    await page.getByLabel('Lowest value').press('Enter');
    await page.locator('#range-error').getByText(said).waitFor();
    assert.equal(await page.getByLabel('Lowest value').getAttribute('aria-describedby'), 'range-error');
  }
  await page.getByLabel('keep range').uncheck();
  assert.equal(await page.locator('#range-error').isVisible(), false);

  await page.getByRole('button', { name: 'Top' }).click();
  await page.getByRole('slider', { name: 'Frame' }).fill('0');
  const box = await page.locator('canvas.stage').boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + 0.4 * box.height);
  await page.waitForFunction(() => /^Course [1-6], wale [1-6]: (knit|purl)$/.test(document.querySelector('.stitch-title').textContent));
  await page.getByLabel('Course of the stitch').fill('1');
  await page.getByLabel('Wale of the stitch').fill('2');
  await page.getByRole('button', { name: 'Show' }).click();
  assert.equal(await page.textContent('.stitch-title'), 'Course 1, wale 2: purl');
  assert.match(await page.textContent('.numbers'), /Largest tension.*mN.*Wrapping angle.*°.*Slid, at most.*mm/);
  await page.getByLabel('Course of the stitch').fill('99');
  await page.getByRole('button', { name: 'Show' }).click();
  await page.locator('#pick-error').getByText('There is no such stitch: courses go from 1 to 6, wales from 1 to 6.').waitFor();
  await shoot(page, 'job-no-stitch');
  await page.getByLabel('Course of the stitch').fill('1');
  await page.getByRole('button', { name: 'Show' }).click();
  assert.equal(await page.locator('#pick-error').isVisible(), false);
  await shoot(page, 'job-stitch');
});

test('plots, picture, history and frames are there to take', async () => {
  const { page, faults } = view;
  await page.locator('svg.plot').nth(2).waitFor();
  assert.match(await page.textContent('.plot-figure figcaption'), /^Energy by effect, change since the start in J/);
  const looks = (place) => page.locator(`.plot-figure:has(.series-legend) ${place} .series`).evaluateAll((lines) => lines.map((line) => {
    const { stroke, strokeDasharray } = getComputedStyle(line);
    return `${stroke} ${strokeDasharray}`;
  }));
  const light = await looks('.plot');
  assert.ok(light.length >= 5 && new Set(light).size === light.length, `each its own: ${light.join('; ')}`);
  assert.deepEqual(await looks('.series-legend'), light);
  await page.getByLabel('Theme').selectOption('dark');
  const dark = await looks('.plot');
  assert.ok(dark.every((look) => !light.includes(look)), dark.join('; '));
  assert.deepEqual(await looks('.series-legend'), dark);
  await shoot(page, 'job-plots-dark', { fullPage: true });
  await page.getByLabel('Theme').selectOption('light');
  await page.getByLabel('energies as change').uncheck();
  const titles = await page.locator('.plot-figure figcaption').allTextContents();
  assert.ok(titles.some((title) => title.startsWith('Energy by effect in J')) && titles.some((title) => title.startsWith('Newton iterations')), titles.join());
  const [picture] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Picture as PNG' }).click()]);
  assert.equal(readFileSync(await picture.path()).subarray(1, 4).toString(), 'PNG');
  const links = await page.locator('.links a, .files a').evaluateAll((all) => all.map((link) => link.getAttribute('href')));
  assert.ok(['obj', 'bcc', 'vtp', 'json'].every((format) => links.some((link) => link.endsWith(`format=${format}`))), links.join());
  assert.ok(links.some((link) => link.endsWith('/history.csv')), links.join());
  for (const link of links) assert.equal((await fetch(new URL(link, server.address))).status, 200, link);
  await page.getByLabel('All frames as').selectOption('json');
  const [archive] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Download zip' }).click()]);
  assert.equal(readFileSync(await archive.path()).subarray(0, 2).toString(), 'PK');
  assert.deepEqual(faults, []);
});

test('a copy of the job is edited from its own scene', async () => {
  const { page, faults } = view;
  await page.evaluate(() => sessionStorage.clear());  // or the draft that it came from would still be there
  const job = page.url();
  await page.getByRole('link', { name: 'Edit a copy' }).click();
  await page.waitForFunction(() => document.querySelector('#field-duration_s')?.value === '0.2');
  const rows = await rowsOf(page);
  assert.deepEqual([rows.length, rows[5], rows[2]], [6, 'KPKKKK', 'KKPPPK']);
  await page.getByRole('button', { name: 'Check' }).click();
  await page.getByText('The scene can be run.').waitFor();
  assert.equal(await page.getByRole('button', { name: 'Bring that back' }).count(), 0, 'nothing was edited before');

  // What was changed in it is there after a reload, and after Back from its job.
  const name = page.locator('#field-name');
  const isNamed = (text) => page.waitForFunction((wanted) => document.querySelector('#field-name')?.value === wanted, text);
  await name.fill('changed copy');
  await name.blur();
  await page.reload();
  await isNamed('changed copy');
  await page.getByRole('button', { name: 'Submit' }).click();
  await page.waitForURL(/#\/jobs\//);
  await page.goBack();
  await isNamed('changed copy');

  // Another copy takes its place, but it can be brought back: after changes, reloads, and a second copy in place of the
  // first.
  const copyOf = async (address) => {
    await page.goto(address);
    await page.getByRole('link', { name: 'Edit a copy' }).click();
    await page.waitForURL(/#\/new$/);
  };
  const told = page.getByText('A copy took the place of the scene that was edited here.');
  const back = page.getByRole('button', { name: 'Bring that back' });
  await page.getByLabel('Threads', { exact: true }).fill('3');
  await page.getByLabel('Threads', { exact: true }).press('Enter');
  await copyOf(job);
  await told.waitFor();
  await shoot(page, 'copy');
  assert.notEqual(await name.inputValue(), 'changed copy');
  assert.notEqual(await page.getByLabel('Threads', { exact: true }).inputValue(), '3');
  await page.reload();
  await told.waitFor();
  await copyOf(`${server.address}/#/jobs/${await submit(server.address, { ...smallScene, name: 'another', duration_s: 0.01 })}`);
  await isNamed('another');
  await name.fill('second copy');
  await name.blur();
  await page.reload();
  await isNamed('second copy');
  await back.click();
  await isNamed('changed copy');
  assert.equal(await page.getByLabel('Threads', { exact: true }).inputValue(), '3');
  await told.waitFor({ state: 'hidden' });
  await page.reload();
  await isNamed('changed copy');
  assert.equal(await back.count(), 0);

  // Of drafts that somebody made the newest is offered first, then the one before it; they can be dismissed.
  await copyOf(job);
  await name.fill('third copy');
  await name.blur();
  await copyOf(job);
  await page.getByText('Then an older one is offered.').waitFor();
  await page.reload();
  await back.click();
  await isNamed('third copy');
  await back.click();
  await isNamed('changed copy');
  await told.waitFor({ state: 'hidden' });
  await name.fill('fourth copy');
  await name.blur();
  await copyOf(job);
  await page.getByRole('button', { name: 'Dismiss' }).click();
  await told.waitFor({ state: 'hidden' });
  await page.reload();
  await name.waitFor();
  assert.equal(await back.count(), 0);

  // It is not offered where it is as the copy is, nor once Undo has brought it back.
  await copyOf(job);
  assert.equal(await back.count(), 0);
  await name.fill('undone');
  await name.blur();
  await copyOf(job);
  await told.waitFor();
  await page.getByRole('button', { name: 'Undo' }).click();
  await isNamed('undone');
  await told.waitFor({ state: 'hidden' });
  assert.deepEqual(faults, []);
});
