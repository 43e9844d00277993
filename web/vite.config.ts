import { cpSync, createReadStream, existsSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';
import { minifyModules } from './element/minify-modules.ts';

const root = fileURLToPath(new URL('.', import.meta.url));
const samples = join(root, '../build/samples');

/** Shared memory, which cancels a running reduction without ending its worker, needs a page isolated from other origins. */
const isolation = {
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cross-Origin-Embedder-Policy': 'require-corp',
};

/** Workers obey the policy that they come with, not that of the page. */
const policy = {
  'Content-Security-Policy':
    "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; img-src 'self' data: blob:; connect-src 'self' https:",
};

/** The generated sample surfaces, under `samples/` of the page: served as they are, and copied into a build. */
function sampleFiles(): Plugin {
  let output = '';
  return {
    name: 'sample-files',
    configResolved({ build }) {
      output = build.outDir;
    },
    configureServer(server) {
      server.middlewares.use('/samples', (request, response, next) => {
        const name = (request.url ?? '').slice(1);
        const file = join(samples, name);
        if (!/^[\w-]+\.(ply|json)$/.test(name) || !existsSync(file)) return next();
        createReadStream(file).pipe(response);
      });
    },
    writeBundle() {
      const wanted = (path: string) => !/\.[^/.]+$/.test(path) || /\.(ply|json)$/.test(path);
      if (existsSync(samples)) cpSync(samples, join(output, 'samples'), { recursive: true, filter: wanted });
    },
  };
}

export default defineConfig({
  root,
  base: './',
  // A file that is missing is missing, not the page again.
  appType: 'mpa',
  plugins: [sampleFiles(), minifyModules()],
  // The WebAssembly module stays a file of its own, which streams and is cached.
  build: {
    outDir: join(root, '../dist'),
    emptyOutDir: true,
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 1024,
    rolldownOptions: { input: [join(root, 'index.html'), join(root, 'element.html')] },
  },
  worker: { format: 'es' },
  server: { headers: isolation },
  preview: { headers: { ...isolation, ...policy } },
});
