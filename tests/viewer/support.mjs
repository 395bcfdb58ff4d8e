// SPDX-License-Identifier: MIT
// A real server with its worker, and a real browser that draws in software.
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { createInterface } from 'node:readline';

export const root = resolve(import.meta.dirname ?? new URL('.', import.meta.url).pathname, '../..');
const requireOfViewer = createRequire(join(root, 'clients/viewer/package.json'));
export const { chromium } = requireOfViewer('playwright-core');
export const axePath = requireOfViewer.resolve('axe-core/axe.min.js');

const hangGuardMs = 120_000;
const binaries = process.env.SLIPSTITCH_BIN_DIR ?? join(root, 'build/bin');
export const viewer = process.env.SLIPSTITCH_VIEWER_DIR ?? join(root, 'build/viewer');
export const shots = process.env.SLIPSTITCH_SHOTS_DIR ?? join(root, 'build/viewer-shots');

function chromiumPath() {
  const found = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find((path) => existsSync(path));
  if (!found) throw new Error('there is no Chromium here: apt-get install --no-install-recommends chromium');
  return found;
}

/// Starts slipstitchd; the answer has its address and `stop`.
export async function startServer(options = []) {
  const data = mkdtempSync(join(tmpdir(), 'slipstitch-viewer-'));
  const child = spawn(join(binaries, 'slipstitchd'), ['--http', '127.0.0.1:0', '--grpc', '127.0.0.1:0', '--data-dir', data,
    '--viewer', viewer, '--stop-jobs', ...options],
    { stdio: ['ignore', 'pipe', 'inherit'], env: { ...process.env, XDG_CACHE_HOME: join(binaries, '../tests/cache') } });
  const exited = new Promise((done) => child.once('exit', (code, signal) => done(signal ?? code)));
  const ready = new Promise((done, failed) => {
    createInterface({ input: child.stdout }).on('line', (line) => {
      const http = /^slipstitchd ready .*http=(\S+)/.exec(line);
      if (http) done(`http://${http[1]}`);
    });
    exited.then((how) => failed(new Error(`slipstitchd ended before it was ready: ${how}`)));
  });
  const address = await ready;
  const stop = async () => {
    child.kill('SIGTERM');
    const how = await exited;
    rmSync(data, { recursive: true, force: true });
    if (how !== 0) throw new Error(`slipstitchd ended with ${how}`);
  };
  return { address, stop, data };
}

export function startBrowser() {
  return chromium.launch({
    executablePath: chromiumPath(),
    args: ['--headless=new', '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-dev-shm-usage'],
    timeout: hangGuardMs,
  });
}

/// A page that fails the test on any error of its scripts, on anything it asks of another host and on what the content
/// security policy stops.
export async function openPage(browser, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, colorScheme: 'light', ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(hangGuardMs);
  const faults = [];
  page.on('pageerror', (error) => faults.push(String(error)));
  page.on('console', (message) => {
    if (/Content Security Policy|Refused to/.test(message.text())) faults.push(message.text());
  });
  page.on('request', (request) => {
    if (!/^(http:\/\/127\.0\.0\.1:|blob:)/.test(request.url())) faults.push(`asked for ${request.url()}`);
  });
  return { page, faults, close: () => context.close() };
}

export async function shoot(page, name, options = {}) {
  mkdirSync(shots, { recursive: true });
  await page.screenshot({ path: join(shots, `${name}.png`), ...options });
}

/// Sends a scene as a client would.
export async function submit(address, scene, work = { simulate: {} }) {
  const response = await fetch(`${address}/v1/simJobs`, {
    method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify({ spec: { scene, ...work } }),
  });
  const job = await response.json();
  if (!response.ok) throw new Error(`the server refused: ${JSON.stringify(job)}`);
  return job.name.replace('simJobs/', '');
}

export async function getJob(address, id) {
  return (await fetch(`${address}/v1/simJobs/${id}`)).json();
}

/// Frames the run has made; 0 before its first report.
export async function framesMade(address, id) {
  return (await getJob(address, id)).progress?.frames ?? 0;
}

export const smallScene = {
  name: 'small',
  knit: {
    chart: { rows: Array.from({ length: 6 }, () => 'KKKKKK') },
    gauge: { course_spacing_m: 0.0029, wale_spacing_m: 0.00203 },
    placement: { course_direction: [1, 0, 0], wale_direction: [0, 0, -1] },
  },
  effects: {
    inertia: {}, gravity: {}, stretch: {}, bending: {}, bending_jamming: {}, wrapping: { alpha: 0.03 }, contact_length: {}, parallel_contact: {},
    sliding: {}, sliding_friction: {}, damping: { bending_nm2s: 1.35e-8, wrapping_ns: 9e-3, sliding_ns_per_m: 10 },
  },
  handles: [{ where: { corner: 'TOP_LEFT' } }, { where: { corner: 'TOP_RIGHT' } }],
  duration_s: 0.2,
};

/// A study of it takes seconds.
export const swing = {
  name: 'swing',
  yarns: [{ points_m: Array.from({ length: 5 }, (_, i) => [0.025 * i, 0, 0]).flat() }],
  effects: { inertia: {}, gravity: {}, stretch: {} },
  handles: [{ where: { yarn_point: {} } }],
  duration_s: 0.1, frames_per_s: 30,
};

/// Runs on until it is cancelled.
export const endlessScene = { ...smallScene, name: 'endless', duration_s: 1000, frames_per_s: 100 };

export async function untilEnded(address, id) {
  for (;;) {
    const job = await getJob(address, id);
    if (['SUCCEEDED', 'FAILED', 'CANCELLED'].includes(job.state)) return job;
    await new Promise((done) => setTimeout(done, 100));
  }
}

export function untilState(page, text) {
  return page.waitForFunction((wanted) => document.querySelector('.job-head .state')?.textContent === wanted, text);
}

export function untilProgress(page, pattern) {
  return page.locator('.progress-text').getByText(pattern).waitFor();
}

export function untilFrame(page, least) {
  return page.waitForFunction((index) => Number(document.querySelector('canvas.stage')?.dataset.frame ?? -1) >= index, least);
}

/// Waits until all plots reach a simulated time in s.
export function untilPlotted(page, least) {
  return page.waitForFunction((t) => {
    const ends = [...document.querySelectorAll('svg.plot')].map((plot) => Number(/ over (\S+) s\./.exec(plot.ariaLabel)?.[1]));
    return ends.length > 0 && ends.every((end) => end >= t);
  }, least);
}

/// Parts of the picture's pixels that are yarn or bodies, and that are red and blue among them, how many different colours
/// they have, their mean and the box around them in px. Read from a picture of the page, so that it is what a person sees.
export async function pictureFacts(page) {
  const png = await page.locator('.stage-frame').screenshot();
  return page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    const colours = new Set();
    const sum = [0, 0, 0];
    const box = [Infinity, Infinity, -Infinity, -Infinity];
    let [covered, reds, blues] = [0, 0, 0];
    for (let i = 0; i < data.length; i += 4) {
      const [r, g, b] = data.subarray(i, i + 3);
      if (Math.max(r, g, b) - Math.min(r, g, b) < 24) continue;  // the background is grey
      covered += 1;
      const [x, y] = [(i / 4) % image.width, Math.floor(i / 4 / image.width)];
      box.splice(0, 4, Math.min(box[0], x), Math.min(box[1], y), Math.max(box[2], x), Math.max(box[3], y));
      if (r > b + 60) reds += 1;
      if (b > r + 40) blues += 1;
      [r, g, b].forEach((value, channel) => { sum[channel] += value; });
      colours.add((r >> 4) * 256 + (g >> 4) * 16 + (b >> 4));
    }
    return { covered: covered / (data.length / 4), reds: reds / (data.length / 4), blues: blues / (data.length / 4), colours: colours.size, box, mean: sum.map((value) => value / Math.max(covered, 1)) };
  }, png.toString('base64'));
}
