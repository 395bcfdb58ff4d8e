// SPDX-License-Identifier: MIT
// A 30×30 job as a person makes it: from the editor, by Submit.
import { smallScene } from './support.mjs';

/// Its second frame is a second of simulated time after the first: minutes of work.
export const swatchScene = {
  ...smallScene, name: 'swatch', duration_s: 1000, frames_per_s: 1,
  knit: { ...smallScene.knit, chart: { rows: Array.from({ length: 30 }, () => 'K'.repeat(30)) } },
};

/// Ready to submit `scene`.
export async function openEditor(page, address, scene) {
  await page.goto(`${address}/#/new`);
  await page.getByText('Scene as JSON').click();
  await page.getByLabel('Scene as JSON').fill(JSON.stringify(scene));
  await page.getByRole('button', { name: 'Use this JSON' }).click();
}

export async function submitUntilDrawn(page) {
  await page.getByRole('button', { name: 'Submit' }).click();
  await page.locator('canvas.stage[data-drawn]').waitFor();
}
