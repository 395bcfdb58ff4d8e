// SPDX-License-Identifier: MIT
import { ApiError } from '../api/api_error';
import { artefactAddress, listArtefacts } from '../api/sim_jobs';
import { h } from '../ui/dom';
import { sleep, whileSeen } from '../ui/presence';
import { Signal } from '../ui/signal';
import type { JobModel } from './job_model';

const againMs = 2000;  // after an answer that did not come

export interface FileList {
  element: HTMLElement;
  names: Signal<readonly string[] | undefined>;  // undefined: not known in the job's state now
}

/// Links to the files that a job has so far.
export function fileList(model: JobModel): FileList {
  const element = h('ul', { class: 'files' });
  const names = new Signal<readonly string[] | undefined>(undefined);
  const asked = { times: 0 };
  /// Until there is an answer, or it is asked for anew.
  const listFiles = async (): Promise<void> => {
    const time = ++asked.times;
    for (;;) {
      const seen = await whileSeen(model.left);
      seen.abort();
      if (model.left.aborted || time !== asked.times) return;
      try {
        const found = (await listArtefacts(model.id)).map((artefact) => (artefact.name ?? '').replace(/^.*\//, ''));
        if (time !== asked.times) return;
        element.replaceChildren(...found.map((name) => h('li', {}, h('a', { href: artefactAddress(model.id, name), download: name }, name))));
        return names.set(found);
      } catch (error) {
        if (error instanceof ApiError && error.httpStatus === 404) return;  // the job is gone
        await sleep(againMs, model.left);
      }
    }
  };
  const seen = { state: '', history: false };
  model.job.subscribe((job) => {
    if (!job || job.state === seen.state) return;
    seen.state = job.state ?? '';
    names.set(undefined);
    void listFiles();
  });
  // Files come while the run goes on: the first with its first frame.
  model.history.subscribe((history) => {
    if (history && !seen.history) void listFiles();
    seen.history = history !== undefined;
  });
  return { element, names };
}
