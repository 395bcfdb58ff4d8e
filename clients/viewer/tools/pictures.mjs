// SPDX-License-Identifier: MIT
// pictures.mjs FOLDER: the pictures of the README, taken of the viewer while a real server runs the demo's drape:
// viewer.png and drape.gif.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { root, openPage, startBrowser, startServer, submit, untilEnded } from '../../../tests/viewer/support.mjs';
import { animation } from './animation.mjs';

const folder = process.argv[2];
if (!folder) throw new Error('usage: pictures.mjs FOLDER');
const scene = JSON.parse(readFileSync(join(root, 'scenes/stockinette-drape.json'), 'utf8'));
const mostBytes = 2_000_000;
const gif = { width: 560, height: 430, frames: 42, framesPerSecond: 12 };

/// With all its frames there.
async function openJob(browser, { address, frames }, viewport, sharpness) {
  const view = await openPage(browser, { viewport, deviceScaleFactor: sharpness });
  await view.page.goto(address);
  await view.page.locator('canvas.stage[data-drawn]').waitFor();
  await view.page.waitForFunction(() => document.querySelector('.job-head .state').textContent === 'Done');
  await view.page.waitForFunction((max) => document.querySelector('[aria-label="Frame"]').max === String(max), frames - 1);
  return view.page;
}

/// Shows another frame than the one that is shown, and waits until it is drawn.
async function showFrame(page, place) {
  const drawn = await page.locator('canvas.stage').getAttribute('data-drawn');
  await page.getByRole('slider', { name: 'Frame' }).fill(String(place));
  await page.waitForFunction((before) => document.querySelector('canvas.stage').dataset.drawn !== before, drawn);
}

async function screenshot(browser, job) {
  const page = await openJob(browser, job, { width: 1280, height: 860 }, 1);
  await page.locator('svg.plot').first().waitFor();
  await showFrame(page, Math.round(await lastPlace(page) / 2));
  await page.getByLabel('Colour by').selectOption('slid');
  await page.getByLabel('Course of the stitch').fill('12');
  await page.getByLabel('Wale of the stitch').fill('14');
  await page.getByRole('button', { name: 'Show' }).click();
  await page.getByRole('button', { name: 'Fit' }).click();
  await showFrame(page, Math.round(await lastPlace(page) / 2) + 1);
  await page.evaluate(() => document.activeElement.blur());
  writeFileSync(join(folder, 'viewer.png'), await page.screenshot());
}

async function lastPlace(page) {
  return Number(await page.getByRole('slider', { name: 'Frame' }).getAttribute('max'));
}

/// The pixels of the picture, RGBA, as a person sees them.
async function pixels(page) {
  const png = (await page.locator('.stage-frame').screenshot()).toString('base64');
  const base64 = await page.evaluate(async ([text, width, height]) => {
    const image = await createImageBitmap(new Blob([Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))], { type: 'image/png' }));
    const canvas = new OffscreenCanvas(width, height);
    const context = canvas.getContext('2d');
    context.imageSmoothingQuality = 'high';
    context.drawImage(image, 0, 0, width, height);
    const { data } = context.getImageData(0, 0, width, height);
    let binary = '';
    for (let at = 0; at < data.length; at += 30_000) binary += String.fromCharCode(...data.subarray(at, at + 30_000));
    return btoa(binary);
  }, [png, gif.width, gif.height]);
  return new Uint8Array(Buffer.from(base64, 'base64'));
}

async function animate(browser, job) {
  // On a narrow page the picture is as wide as the page and about half as high.
  const page = await openJob(browser, job, { width: gif.width + 22, height: Math.round(gif.height / 0.52) }, 2);
  // An even background, which a GIF's few colours can show.
  await page.evaluate(() => { document.querySelector('.stage-frame').style.background = '#f4f5f6'; });
  await showFrame(page, Math.round(await lastPlace(page) / 3));
  await page.getByRole('button', { name: 'Fit' }).click();
  await page.locator('canvas.stage').press('ArrowRight');  // a camera that a person has moved stays where it is
  await page.locator('canvas.stage').press('-');
  const frames = [];
  for (let place = 0; place <= Math.min(await lastPlace(page), gif.frames - 1); ++place) {
    await showFrame(page, place);
    frames.push(await pixels(page));
  }
  const bytes = animation(frames, gif, mostBytes);
  writeFileSync(join(folder, 'drape.gif'), bytes);
  console.log(`${frames.length} frames in drape.gif, ${bytes.length} bytes`);
}

const server = await startServer();
const browser = await startBrowser();
try {
  mkdirSync(folder, { recursive: true });
  const id = await submit(server.address, scene);
  const job = await untilEnded(server.address, id);
  if (job.state !== 'SUCCEEDED') throw new Error(`the drape ended as ${job.state}`);
  const shown = { address: `${server.address}/#/jobs/${id}`, frames: job.progress.frames };
  await screenshot(browser, shown);
  await animate(browser, shown);
} finally {
  await browser.close();
  await server.stop();
}
