// SPDX-License-Identifier: MIT
import { artefactAddress, listArtefacts } from '../api/sim_jobs';
import { h } from '../ui/dom';
import { Signal } from '../ui/signal';
import type { JobModel } from './job_model';

export interface FileList {
  element: HTMLElement;
  names: Signal<readonly string[]>;
}

/// Links to the files that a job has so far.
export function fileList(model: JobModel): FileList {
  const element = h('ul', { class: 'files' });
  const names = new Signal<readonly string[]>([]);
  const listFiles = (): void => {
    listArtefacts(model.id).then((artefacts) => {
      names.set(artefacts.map((artefact) => (artefact.name ?? '').replace(/^.*\//, '')));
      element.replaceChildren(...names.value.map((name) => h('li', {}, h('a', { href: artefactAddress(model.id, name), download: name }, name))));
    }).catch(() => undefined);  // asked again with the next state
  };
  const seen = { state: '', history: false };
  model.job.subscribe((job) => {
    if (!job || job.state === seen.state) return;
    seen.state = job.state ?? '';
    listFiles();
  });
  // Files come while the run goes on: the first with its first frame.
  model.history.subscribe((history) => {
    if (history && !seen.history) listFiles();
    seen.history = history !== undefined;
  });
  return { element, names };
}
