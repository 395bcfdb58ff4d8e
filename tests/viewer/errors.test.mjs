// SPDX-License-Identifier: MIT
// What is wrong with a scene is shown at the field that caused it.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openPage, shoot, smallScene, startBrowser, startServer } from './support.mjs';

let server, browser, view;
before(async () => {
  server = await startServer();
  browser = await startBrowser();
  view = await openPage(browser);
  await view.page.goto(server.address);
});
after(async () => {
  await browser?.close();
  await server?.stop();
});

const errorAt = (page, path) => page.locator(`[data-path="${path}"] > .field-error`);

test('the server names a field: the error is at it, and the summary leads there', async () => {
  const { page } = view;
  await page.getByText('Yarn', { exact: true }).click();
  await page.getByLabel('Radius mm').fill('-1');
  await page.getByRole('switch', { name: 'Sliding', exact: true }).uncheck();
  await page.getByRole('button', { name: 'Submit' }).click();
  await errorAt(page, 'yarn.radius_m').waitFor();
  assert.match(await errorAt(page, 'yarn.radius_m').textContent(), /^is -1 mm, expected a finite number > 0 mm$/);
  assert.match(await page.locator('.error-summary a', { hasText: 'yarn.radius_m' }).textContent(), /is -0\.001, expected a finite number > 0$/, 'as the server says it');
  assert.equal(await page.getByLabel('Radius mm').getAttribute('aria-invalid'), 'true');
  assert.match(await errorAt(page, 'effects.sliding_friction').textContent(), /expected effects\.sliding listed too/);
  assert.match(await page.textContent('.error-summary h2'), /problems/);
  assert.match(page.url(), /127\.0\.0\.1:\d+\/?(#\/new)?$/, 'no job was made');
  await shoot(page, 'errors', { fullPage: true });

  await page.locator('.error-summary a', { hasText: 'yarn.radius_m' }).click();
  assert.equal(await page.evaluate(() => document.activeElement.id), 'field-yarn-radius_m');
});

test('an error goes when its field changes', async () => {
  const { page } = view;
  await page.getByLabel('Radius mm').fill('0.5');
  await page.getByLabel('Radius mm').press('Enter');
  assert.equal(await errorAt(page, 'yarn.radius_m').isVisible(), false);
  assert.equal(await errorAt(page, 'effects.sliding_friction').isVisible(), true);
});

test('what is no number is said at once and never sent', async () => {
  const { page } = view;
  const asked = [];
  page.on('request', (request) => request.method() === 'POST' && asked.push(request.url()));
  await page.getByLabel('Duration s').fill('soon');
  await page.getByLabel('Duration s').press('Enter');
  assert.match(await errorAt(page, 'duration_s').textContent(), /is “soon”, expected a number/);
  await page.getByRole('button', { name: 'Submit' }).click();
  assert.deepEqual(asked, []);
  await page.getByLabel('Duration s').fill('0.1');
  await page.getByLabel('Duration s').press('Enter');
});

test('errors deep in lists open what hides them; those without a place are in the summary', async () => {
  const { page, faults } = view;
  await page.getByRole('switch', { name: 'Colliders' }).check();
  await page.getByLabel('Radius mm').last().fill('0');
  await page.getByLabel('Radius mm').last().press('Enter');
  await page.locator('details:has(> summary:text("Parameters of Colliders"))').evaluate((details) => { details.open = false; });
  await page.getByRole('button', { name: 'Check' }).click();
  await errorAt(page, 'effects.colliders.colliders[0].sphere.radius_m').waitFor();
  await page.getByText('Scene as JSON').click();
  await page.getByLabel('Scene as JSON').fill('{"knit": {"chart": {"rows": ["KK", "KK"]}}, "unknown_thing": 1}');
  await page.getByRole('button', { name: 'Use this JSON' }).click();
  await page.getByRole('button', { name: 'Check' }).click();
  await page.locator('.error-summary li', { hasText: 'unknown_thing' }).waitFor();
  assert.deepEqual(faults, []);
});

const loadFile = (page, name, text) => page.locator('input[type=file]').setInputFiles({ name, mimeType: 'application/json', buffer: Buffer.from(text) });

async function useJson(page, scene) {
  await page.getByLabel('Scene as JSON').fill(typeof scene === 'string' ? scene : JSON.stringify(scene));
  await page.getByRole('button', { name: 'Use this JSON' }).click();
}

test('a file that is no scene is refused by name and place, beside nothing that is about another one', async () => {
  const { page, faults } = view;
  assert.ok(await page.locator('.error-summary').isVisible());
  await loadFile(page, 'twice.json', '{"name": "a",\n "name": "b"}');
  await page.locator('.error-box', { hasText: 'twice.json was not loaded: name stands there twice, the second time in line 2, column 2' }).waitFor();
  assert.equal(await page.locator('.error-summary').isVisible(), false);
  await shoot(page, 'not-loaded');
  await useJson(page, '{"name": "a", "name": "b"}');
  await page.locator('#json-error', { hasText: 'name stands there twice' }).waitFor();
  await useJson(page, smallScene);
  assert.equal(await page.locator('#json-error').isVisible(), false);
  assert.equal(await page.locator('.error-box').isVisible(), false, 'the scene is another one now');
  assert.deepEqual(faults, []);
});

test('that a scene can be run is said of this scene only', async () => {
  const { page } = view;
  const said = page.getByText('The scene can be run.');
  await page.getByRole('button', { name: 'Check' }).click();
  await said.waitFor();
  await page.getByLabel('Duration s').fill('0.3');
  await page.getByLabel('Duration s').press('Enter');
  assert.equal(await said.count(), 0);
});

test('values of a wrong type are said where their fields are', async () => {
  const { page } = view;
  await useJson(page, { ...smallScene, yarn: 3, knit: null });
  await page.getByRole('button', { name: 'Check' }).click();
  await errorAt(page, 'yarn').getByText('is 3, expected an object').waitFor();
  await errorAt(page, 'knit').getByText('is null, expected an object').waitFor();
  await errorAt(page, 'knit.gauge').getByText('expected either course_spacing_m').waitFor();
  await page.locator('.error-summary a', { hasText: 'yarn is 3' }).click();
  assert.equal(await page.evaluate(() => document.activeElement.closest('details').querySelector('h2').textContent), 'Yarn');
  await shoot(page, 'wrong-types', { fullPage: true });
});

test('a number that must be there and is not is said before anything is sent', async () => {
  const { page } = view;
  await useJson(page, smallScene);
  await page.getByLabel('Numerics').selectOption('accuracy');
  const asked = [];
  page.on('request', (request) => request.method() === 'POST' && asked.push(request.url()));
  await page.getByLabel('Goal').selectOption('budget_s');
  await page.getByRole('button', { name: 'Check' }).click();
  await errorAt(page, 'accuracy.budget_s').getByText('is empty, expected a number').waitFor();
  await page.getByLabel('Goal').selectOption('tolerance_m');
  await page.getByRole('button', { name: 'Check' }).click();
  await errorAt(page, 'accuracy.tolerance_m').getByText('is empty, expected a number').waitFor();
  assert.deepEqual(asked, []);
  await page.getByLabel('Error of positions mm').fill('0.1');
  await page.getByLabel('Error of positions mm').press('Enter');
  await page.getByRole('button', { name: 'Check' }).click();
  await page.getByText('The scene can be run.').waitFor();
  await page.getByLabel('Error of positions mm').fill('0');
  await page.getByLabel('Error of positions mm').press('Enter');
  await page.getByRole('button', { name: 'Check' }).click();
  await errorAt(page, 'accuracy.tolerance_m').getByText('is 0 mm, expected a finite number').waitFor();
  await useJson(page, { ...smallScene, fixed: {}, accuracy: { tolerance_m: 1e-4 } });
  await page.getByRole('button', { name: 'Check' }).click();
  await page.locator('.error-summary a', { hasText: 'accuracy is a second choice' }).waitFor();
  await useJson(page, { ...smallScene, accuracy: { tolerance_m: 1e-4, budget_s: 10 } });
  await page.getByRole('button', { name: 'Check' }).click();
  await page.locator('.error-summary a', { hasText: 'is a second choice' }).waitFor();
  await useJson(page, { ...smallScene, accuracy: {} });
  await page.getByRole('button', { name: 'Check' }).click();
  await errorAt(page, 'accuracy').getByText('expected either tolerance_m or budget_s').waitFor();
});

test('the chart says what it cannot do', async () => {
  const { page, faults } = view;
  await useJson(page, smallScene);
  const problem = page.locator('#chart-size-problem');
  const courses = page.getByLabel('Courses', { exact: true });
  const rows = () => page.locator('canvas.chart').getAttribute('data-courses');
  for (const [typed, said] of [['', 'Courses is empty, expected a whole number from 2 to 400.'], ['0', 'Courses is 0, expected a whole number from 2 to 400.'], ['-3', 'Courses is -3,']]) {
    await courses.fill(typed);
    await courses.press('Enter');
    await courses.blur();
    await problem.getByText(said).waitFor();
    assert.equal(await courses.getAttribute('aria-invalid'), 'true');
    assert.equal(await rows(), '6');
  }
  await page.getByLabel('Times upwards').fill('100');
  await page.getByRole('button', { name: 'Repeat' }).click();
  await problem.getByText('Times upwards is 100, expected a whole number from 1 to 66, as a chart has at most 400.').waitFor();
  assert.equal(await rows(), '6');
  await page.getByRole('button', { name: 'Paste rows' }).click();
  await page.locator('.chart-status', { hasText: 'There is nothing to paste: copy rows first.' }).waitFor();
  await shoot(page, 'chart-problem');
  await courses.fill('7');
  await courses.press('Enter');
  assert.equal(await problem.isVisible(), false);
  assert.equal(await rows(), '7');
  assert.deepEqual(faults, []);
});

test('a size that no chart can have is a problem like any other, and nothing is sent', async () => {
  const { page, faults } = view;
  await useJson(page, smallScene);
  const courses = page.getByLabel('Courses', { exact: true });
  const asked = [];
  page.on('request', (request) => request.method() === 'POST' && asked.push(request.url()));
  for (const typed of ['1000', '1.5']) {
    await courses.fill(typed);
    for (const name of ['Check', 'Submit']) {
      await page.getByRole('button', { name }).click();
      await page.locator('.error-summary li', { hasText: `Courses is ${typed}, expected a whole number from 2 to 400` }).waitFor();
      assert.equal(await page.getByText('The scene can be run.').count(), 0);
    }
    assert.equal(await courses.getAttribute('aria-invalid'), 'true');
  }
  assert.deepEqual(asked, []);
  await page.getByLabel('Duration s').fill('0.25');
  await page.getByLabel('Duration s').press('Enter');
  await page.getByLabel('Stitch width mm').fill('2.8');
  await page.getByLabel('Stitch width mm').press('Enter');
  await page.getByLabel('Numerics').selectOption('accuracy');
  await page.getByLabel('Numerics').selectOption('');
  assert.equal(await courses.inputValue(), '1.5', 'what was typed stays until it is mended');
  await page.locator('.error-summary a', { hasText: 'Courses is 1.5' }).click();
  assert.equal(await page.evaluate(() => document.activeElement.ariaLabel), 'Courses');
  await courses.fill('8');
  await courses.press('Enter');
  assert.equal(await page.locator('.error-summary').isVisible(), false);
  await page.getByLabel('Wales', { exact: true }).fill('0');
  await page.getByLabel('Wales', { exact: true }).press('Enter');
  await page.locator('.error-summary li', { hasText: 'Wales is 0' }).waitFor();
  await useJson(page, smallScene);
  assert.equal(await page.locator('.error-summary').isVisible(), false, 'it was about another chart');
  assert.equal(await page.getByLabel('Wales', { exact: true }).inputValue(), '6');
  assert.deepEqual(faults, []);
});

test('what is wrong with the job beside its scene is told at its field, within the bounds of the server', async () => {
  const { page, faults } = view;
  await useJson(page, smallScene);
  await page.getByLabel('Work', { exact: true }).selectOption('study');
  const [threads, budget] = [page.getByLabel('Threads', { exact: true }), page.getByLabel('Budget in s')];
  for (const [field, typed, said] of [[threads, '1025', 'is 1025, expected 0 to 1024'], [budget, '-0.5', 'is -0.5, expected a finite number >= 0']]) {
    await field.fill(typed);
    await field.press('Enter');
    await page.locator('.error-summary a', { hasText: said }).waitFor();
    assert.equal(await field.getAttribute('aria-invalid'), 'true');
    const place = await field.getAttribute('aria-describedby');
    assert.equal(await page.locator(`#${place}`).textContent(), said);
    assert.ok(await page.locator(`#${place}`).isVisible());
  }
  assert.equal(await page.textContent('.error-summary h2'), 'This job has 2 problems');
  const lines = await page.locator('.error-summary li').allTextContents();
  assert.deepEqual(lines, ['Budget in s is -0.5, expected a finite number >= 0', 'Threads is 1025, expected 0 to 1024']);
  const asked = [];
  page.on('request', (request) => request.method() === 'POST' && asked.push(request.url()));
  await page.getByRole('button', { name: 'Submit' }).click();
  assert.equal(await page.evaluate(() => document.activeElement.className), 'error-summary', 'as for any other field');
  assert.deepEqual(asked, []);
  await page.locator('.error-summary a', { hasText: 'Threads is 1025' }).click();
  assert.ok(await threads.evaluate((input) => input === document.activeElement));
  await shoot(page, 'errors-order');
  await page.getByLabel('Work', { exact: true }).selectOption('simulate');
  assert.equal(await page.textContent('.error-summary h2'), 'This job has a problem', 'a simulation has no budget');
  await page.getByLabel('Duration s').fill('0.2');
  await page.getByLabel('Duration s').press('Enter');
  await page.getByLabel('Numerics').selectOption('accuracy');
  await page.getByLabel('Numerics').selectOption('');
  assert.equal(await threads.getAttribute('aria-invalid'), 'true', 'until it is mended');
  for (const right of ['0', '1024', '']) {
    await threads.fill(right);
    await threads.press('Enter');
    assert.equal(await page.locator('.error-summary').isVisible(), false);
    assert.equal(await threads.getAttribute('aria-invalid'), null);
    await page.getByRole('button', { name: 'Check' }).click();
    await page.getByText('The scene can be run.').waitFor();
  }
  assert.deepEqual(faults, []);
});

test('what the server alone refuses of the job is told at its field too, and goes when that changes', async () => {
  const { page, faults } = view;
  const refused = (violations) => (route) => (JSON.parse(route.request().postData()).spec.threads === undefined ? route.continue() : route.fulfill({ status: 400, json: {
    code: 3, message: 'no', details: [{ '@type': 'type.googleapis.com/google.rpc.BadRequest', field_violations: violations }] } }));
  await page.route('**/v1/simJobs', refused([{ field: 'spec.threads', description: 'is 3, expected 0 to 2' }, { field: 'spec.work', description: 'is missing' }]));
  const threads = page.getByLabel('Threads', { exact: true });
  await threads.fill('3');
  await threads.press('Enter');
  await page.getByRole('button', { name: 'Check' }).click();
  await errorAt(page, 'Threads').getByText('is 3, expected 0 to 2').waitFor();
  await errorAt(page, 'Work').getByText('is missing').waitFor();
  assert.equal(await page.getByLabel('Work', { exact: true }).getAttribute('aria-invalid'), 'true');
  assert.doesNotMatch(await page.textContent('.error-summary'), /spec\./);
  await threads.fill('');
  await threads.press('Enter');
  assert.equal(await errorAt(page, 'Threads').isVisible(), false);
  assert.equal(await errorAt(page, 'Work').isVisible(), true);
  await page.unroute('**/v1/simJobs');
  await page.route('**/v1/simJobs', (route) => route.abort());
  await page.getByRole('button', { name: 'Check' }).click();
  await page.locator('.error-summary li', { hasText: 'the server cannot be reached' }).waitFor();
  assert.equal(await page.textContent('.error-summary h2'), 'This did not work');
  await page.unroute('**/v1/simJobs');
  assert.deepEqual(faults, []);
});

const wrongPatterns = [
  [{ chart: { rows: 'KK' } }, 'knit.chart.rows is "KK", expected rows of K and P', ['knit.chart', 'rows is "KK", expected an array']],
  [{ chart: { rows: [null, null] } }, 'knit.chart.rows[0] is null, expected a row of K and P', ['knit.chart', 'rows[0] is null']],
  [{ chart: 7 }, 'knit.chart is 7, expected an object', ['knit.chart', 'is 7, expected an object']],
  [{ worked_rows: { rows: ['K', null] } }, 'knit.worked_rows.rows[1] is null, expected a row of K and P', ['knit', 'worked_rows.rows[1] is null']],
  [{ preset: [] }, 'knit.preset is [], expected an object', ['knit', 'knit.preset is ']],
];
for (const [index, [pattern, why, [path, said]]] of wrongPatterns.entries()) {
  test(`stitches that cannot be read are loaded, told of and checked: ${JSON.stringify(pattern)}`, async () => {
    const { page, faults } = view;
    const scene = JSON.stringify({ ...smallScene, name: `evil ${index}`, knit: { ...smallScene.knit, chart: undefined, ...pattern } });
    if (index % 2 === 0) await loadFile(page, 'evil.json', scene);
    else await useJson(page, scene);
    await page.waitForFunction((name) => document.querySelector('#field-name').value === name, `evil ${index}`);
    await page.getByText(`The stitches cannot be shown: ${why}`).waitFor();
    assert.equal(await page.locator('canvas.chart').isVisible(), false, 'not the chart of another scene');
    assert.equal(await page.getByText('The scene is as it was').count(), 0);
    await page.getByRole('button', { name: 'Check' }).click();
    await errorAt(page, path).getByText(said).waitFor();
    if (index === 0) await shoot(page, 'chart-unreadable', { fullPage: true });
    await page.getByRole('button', { name: 'Begin a new chart' }).click();
    assert.equal(await page.locator('canvas.chart').isVisible(), true);
    await page.getByRole('button', { name: 'Check' }).click();
    await page.getByText('The scene can be run.').waitFor();
    assert.deepEqual(faults, []);
  });
}

test('the error of a group goes when a field in it changes', async () => {
  const { page } = view;
  await useJson(page, smallScene);
  const spacing = page.getByLabel('Stitch width mm');
  await spacing.fill('');
  await spacing.press('Enter');
  await page.getByRole('button', { name: 'Check' }).click();
  await errorAt(page, 'knit.gauge').getByText('expected either course_spacing_m').waitFor();
  await spacing.fill('2.9');
  await spacing.press('Enter');
  assert.equal(await errorAt(page, 'knit.gauge').isVisible(), false);
  assert.equal(await page.locator('.error-summary').isVisible(), false);
});

test('a comma between thousands is no number', async () => {
  const { page } = view;
  const radius = page.getByLabel('Radius mm').first();
  await radius.fill('1,000');
  await radius.press('Enter');
  await errorAt(page, 'yarn.radius_m').getByText('is “1,000”, expected a number').waitFor();
  await radius.fill('0,524');
  await radius.press('Enter');
  assert.equal(await page.locator('.error-summary').isVisible(), false);
});
