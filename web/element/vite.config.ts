import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { minifyModules } from './minify-modules.ts';

const root = fileURLToPath(new URL('../..', import.meta.url));

/**
 * The element as an ES module for pages of others: dist/element/meshbound-viewer.js, and beside it the workers, the
 * WebAssembly and the formats' readers and writers, each loaded when it is first needed.
 */
export default defineConfig({
  root,
  base: './',
  publicDir: false,
  plugins: [minifyModules()],
  build: {
    outDir: `${root}dist/element`,
    emptyOutDir: true,
    assetsInlineLimit: 0,
    assetsDir: '.',
    chunkSizeWarningLimit: 1024,
    modulePreload: false,
    rolldownOptions: {
      input: { 'meshbound-viewer': `${root}web/element/index.ts` },
      preserveEntrySignatures: 'strict',
      output: { entryFileNames: '[name].js' },
    },
  },
  worker: { format: 'es' },
});
