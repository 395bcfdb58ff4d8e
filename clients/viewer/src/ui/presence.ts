// SPDX-License-Identifier: MIT

function isHidden(): boolean {
  return document.visibilityState === 'hidden';
}

/// Waits until the window is seen. The answer aborts when it gets hidden, and with `outer`; whoever has it aborts it once
/// done.
export async function whileSeen(outer: AbortSignal): Promise<AbortController> {
  const seen = new AbortController();
  const abort = (): void => seen.abort();
  if (outer.aborted) abort();
  else outer.addEventListener('abort', abort, { signal: seen.signal });
  if (isHidden() && !outer.aborted) {
    await new Promise<void>((resolve) => {
      seen.signal.addEventListener('abort', () => resolve());
      document.addEventListener('visibilitychange', () => resolve(), { once: true, signal: seen.signal });
    });
  }
  document.addEventListener('visibilitychange', () => isHidden() && abort(), { signal: seen.signal });
  return seen;
}

/// Resolves after a time, or when the signal aborts.
export function sleep(ms: number, signal: AbortSignal): Promise<void> {
  return new Promise((resolve) => {
    if (signal.aborted) return resolve();
    const wake = (): void => {
      clearTimeout(timer);
      signal.removeEventListener('abort', wake);
      resolve();
    };
    const timer = setTimeout(wake, ms);
    signal.addEventListener('abort', wake);
  });
}

/// Asks every `everyMs` while the window is seen, at once when it is seen again, until `ask` says that is all.
export async function askWhileSeen(ask: () => Promise<boolean>, everyMs: () => number, outer: AbortSignal): Promise<void> {
  while (!outer.aborted) {
    const seen = await whileSeen(outer);
    while (!seen.signal.aborted) {
      if (await ask()) return seen.abort();
      await sleep(everyMs(), seen.signal);
    }
  }
}
