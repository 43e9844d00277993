import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

export default defineConfig({
  root: fileURLToPath(new URL('.', import.meta.url)),
  base: './',
  build: {
    outDir: fileURLToPath(new URL('../../build/examples-vite', import.meta.url)),
    emptyOutDir: true,
    assetsInlineLimit: 0, // WebAssembly stays a file of its own, which streams and is cached
    chunkSizeWarningLimit: 1024,
  },
  worker: { format: 'es' }, // its workers import as modules do
});
