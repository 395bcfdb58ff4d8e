// SPDX-License-Identifier: MIT
// How long it takes from Submit to the first picture of a 30×30 job, and how much of it the server needs to have the first
// frame: first_picture_bench.mjs [JOBS].
import { getJob, openPage, startBrowser, startServer } from './support.mjs';
import { openEditor, submitUntilDrawn, swatchScene } from './swatch.mjs';

const jobs = Number(process.argv[2] ?? 7);
const print = (what, times) => {
  const sorted = [...times].sort((a, b) => a - b);
  console.log(`${what.padEnd(34)}median ${sorted[sorted.length >> 1].toFixed(2)}  max ${sorted.at(-1).toFixed(2)} s of ${sorted.length} jobs`);
};

/// [s] until the job has its first frame, asked of the server as often as it answers.
async function untilFirstFrame(address, scene) {
  const start = performance.now();
  const response = await fetch(`${address}/v1/simJobs`, {
    method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify({ spec: { scene, simulate: {} } }),
  });
  const id = (await response.json()).name.replace('simJobs/', '');
  while (!((await getJob(address, id)).progress?.frames > 0));
  const seconds = (performance.now() - start) / 1000;
  await fetch(`${address}/v1/simJobs/${id}:cancel`, { method: 'POST' });
  return seconds;
}

async function untilFirstPicture(browser, address, scene) {
  const { page, close } = await openPage(browser);
  await openEditor(page, address, scene);
  const start = performance.now();
  await submitUntilDrawn(page);
  const seconds = (performance.now() - start) / 1000;
  await page.getByRole('button', { name: 'Cancel' }).click();
  await close();
  return seconds;
}

const server = await startServer();
const browser = await startBrowser();
try {
  const [frames, pictures] = [[], []];
  for (let job = 0; job < jobs; ++job) {
    frames.push(await untilFirstFrame(server.address, swatchScene));
    pictures.push(await untilFirstPicture(browser, server.address, swatchScene));
  }
  print('30×30 job, first frame', frames);
  print('30×30 job, first picture', pictures);
} finally {
  await browser.close();
  await server.stop();
}
