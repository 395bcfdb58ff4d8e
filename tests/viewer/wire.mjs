// SPDX-License-Identifier: MIT
// A wire between browser and server that can be cut.
import { connect, createServer } from 'node:net';

/// Hands all bytes on between its own address and `target`. `cut` ends what is open and takes nothing new until `mend`.
export async function startWire(target) {
  const { hostname, port } = new URL(target);
  const sockets = new Set();
  const state = { whole: true };
  const keep = (socket) => {
    sockets.add(socket);
    socket.on('close', () => sockets.delete(socket));
    socket.on('error', () => socket.destroy());
  };
  const server = createServer((near) => {
    keep(near);
    if (!state.whole) {
      near.destroy();
      return;
    }
    const far = connect(Number(port), hostname);
    keep(far);
    near.pipe(far).pipe(near);
    near.on('close', () => far.destroy());
    far.on('close', () => near.destroy());
  });
  await new Promise((listening) => server.listen(0, '127.0.0.1', listening));
  const end = () => {
    for (const socket of sockets) socket.destroy();
  };
  return {
    address: `http://127.0.0.1:${server.address().port}`,
    cut: () => {
      state.whole = false;
      end();
    },
    mend: () => { state.whole = true; },
    stop: () => new Promise((closed) => {
      server.close(closed);
      end();
    }),
  };
}
