import { readFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';

const root = fileURLToPath(new URL('../..', import.meta.url));

/**
 * WebAssembly modules beside the program: the address of each, relative to its source, becomes one relative to the bundle.
 * The module with threads has the same name, but is for pages alone.
 */
function webAssemblyFiles(): Plugin {
  const address = /new URL\('([^']+\/wasm\/[^']+\.wasm)', import\.meta\.url\)/g;
  return {
    name: 'webassembly-files',
    enforce: 'pre',
    transform(code, id) {
      if (!id.startsWith(join(root, 'wasm/'))) return;
      return code.replace(address, (_, path: string) => {
        const fileName = basename(path);
        this.emitFile({ type: 'asset', fileName, source: readFileSync(join(dirname(id), path)) });
        return `new URL('../cli/${fileName}', import.meta.url)`;
      });
    },
  };
}

/** The command line as files that Node runs as they are, without node_modules: build/cli/meshbound.mjs and what it loads. */
export default defineConfig({
  root,
  publicDir: false,
  plugins: [webAssemblyFiles()],
  ssr: { noExternal: true },
  build: {
    ssr: true,
    target: 'node20',
    outDir: join(root, 'build/cli'),
    emptyOutDir: true,
    emitAssets: true,
    rolldownOptions: {
      input: {
        meshbound: join(root, 'web/node-cli/main.ts'),
        // Beside the bundle under the name that wasm/worker-thread.ts starts.
        'worker.node': join(root, 'wasm/worker.ts'),
      },
      output: { entryFileNames: '[name].mjs', chunkFileNames: '[name]-[hash].mjs' },
    },
  },
});
