// SPDX-License-Identifier: MIT
// A browser opens six connections to a server, all its windows together. Streams that stay open may have some of them, so
// that short requests always find one.
const mostStreams = 3;

/// True: a stream may stay open until the signal aborts. Where the page is not trusted with locks (http from another
/// machine) nobody can tell.
export async function takeStreamTurn(signal: AbortSignal): Promise<boolean> {
  if (!navigator.locks) return true;
  const ended = new Promise<void>((resolve) => {
    if (signal.aborted) resolve();
    signal.addEventListener('abort', () => resolve(), { once: true });
  });
  for (let turn = 0; turn < mostStreams; ++turn) {
    const taken = await new Promise<boolean>((resolve, reject) => {
      navigator.locks.request(`slipstitch.stream.${turn}`, { ifAvailable: true }, (lock) => {
        resolve(lock !== null);
        return lock === null ? undefined : ended;
      }).catch(reject);
    });
    if (taken) return true;
  }
  return false;
}
