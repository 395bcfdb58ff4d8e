// SPDX-License-Identifier: MIT
import { frameAddress, frameBytes, frameFormats, type FrameFormat } from '../api/sim_jobs';
import type { Frame } from '../fabric/fabric';
import { button, h, select } from '../ui/dom';
import { saveFile } from '../ui/download';
import { fileList } from './file_list';
import type { JobModel } from './job_model';
import { zip, type ZipEntry } from './zip';

export interface DownloadsPanel {
  element: HTMLElement;
  showFrame(frame: Frame | undefined): void;
  leave(): void;
}

const mostArchiveBytes = 1 << 30;

function frameName(index: number, format: FrameFormat): string {
  return `frame_${String(index).padStart(6, '0')}.${format}`;
}

const fetchedAtOnce = 3;  // as a browser has few connections, and the server a job to run

/// Fetches all frames that there are now, several at a time; throws what the signal was aborted with.
async function archive(model: JobModel, format: FrameFormat, signal: AbortSignal, say: (text: string) => void): Promise<void> {
  const count = (model.store.last?.index ?? -1) + 1;
  const entries: ZipEntry[] = [];
  const at = { next: 0, done: 0, size: 0 };
  const fetchSome = async (): Promise<void> => {
    while (at.next < count) {
      const index = at.next++;
      const bytes = await frameBytes(model.id, index, format, signal);
      at.size += bytes.length;
      if (at.size > mostArchiveBytes) throw new Error(`more than ${mostArchiveBytes >> 20} MiB: use “slipstitch frames” instead`);
      entries[index] = { name: frameName(index, format), bytes };
      say(`Fetched ${++at.done} of ${count} frames`);
    }
  };
  await Promise.all(Array.from({ length: fetchedAtOnce }, fetchSome));
  saveFile(`${model.id}-${format}.zip`, new Blob(zip(entries) as BlobPart[], { type: 'application/zip' }));
  say(`${count} frames in ${model.id}-${format}.zip`);
}

export function downloadsPanel(model: JobModel, picture: () => Promise<Blob>): DownloadsPanel {
  const status = h('p', { class: 'note', role: 'status' });
  const say = (text: string): void => { status.textContent = text; };
  const failed = (error: unknown): void => say(error instanceof Error ? error.message : String(error));
  const links = h('p', { class: 'links' });
  const choice = { format: 'obj' as FrameFormat };
  const fetching = { stop: new AbortController() };
  const setBusy = (busy: boolean): void => {
    download.disabled = busy;
    cancel.hidden = !busy;
  };
  const download = button('Download zip', () => {
    const stop = new AbortController();
    fetching.stop = stop;
    setBusy(true);
    archive(model, choice.format, stop.signal, say)
      .catch((error: unknown) => (stop.signal.aborted ? say('Stopped.') : failed(error)))
      .finally(() => {
        stop.abort();  // the other requests, where one failed
        setBusy(false);
      });
  });
  const cancel = button('Stop', () => fetching.stop.abort(), { hidden: true, 'aria-label': 'Stop the download' });
  const all = h('p', { class: 'links' },
    select('All frames as', frameFormats.map((format) => [format, format] as const), 'obj', (format) => { choice.format = format as FrameFormat; }),
    download, cancel);
  const png = button('Picture as PNG', () => void picture().then((blob) => saveFile(`${model.id}.png`, blob), failed));

  const files = fileList(model);
  const shown = { index: -2 };
  const showFrame = (frame: Frame | undefined): void => {
    const index = frame?.index ?? -1;
    if (index === shown.index) return;
    shown.index = index;
    links.replaceChildren(...(index < 0 ? [] : [`Frame ${index} as `, ...frameFormats.map((format) =>
      h('a', { href: frameAddress(model.id, index, format), download: frameName(index, format) }, format))]));
  };
  const onServer = h('div', {}, links, all, status, h('h3', {}, 'Files of the run'), files.element);
  model.gone.subscribe((gone) => { onServer.hidden = gone; });
  return {
    element: h('section', { class: 'panel', 'aria-label': 'Downloads' }, h('h2', {}, 'Downloads'), h('p', { class: 'links' }, png), onServer),
    showFrame,
    leave: () => fetching.stop.abort(),
  };
}
