// SPDX-License-Identifier: MIT
import { defineConfig } from 'vitest/config';

// The server's content security policy allows its own files, and nothing inline.
export default defineConfig({
  base: './',
  build: {
    outDir: '../../build/viewer',
    emptyOutDir: true,
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 1000,
    reportCompressedSize: false,
  },
  server: { fs: { allow: ['../..'] } },
  test: { include: ['test/**/*.test.ts'], environment: 'node' },
});
