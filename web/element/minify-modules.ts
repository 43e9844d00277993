import { minifySync, type Plugin } from 'vite';

/** Makes small what is copied as it is, because it must not be bundled: the module that starts threads. */
export function minifyModules(): Plugin {
  return {
    name: 'minify-modules',
    generateBundle(_, bundle) {
      for (const file of Object.values(bundle)) {
        if (file.type !== 'asset' || !file.fileName.endsWith('.mjs')) continue;
        const { code, errors } = minifySync(file.fileName, new TextDecoder().decode(bytesOf(file.source)), {
          module: true,
        });
        if (errors.length > 0) this.error(`${file.fileName}: ${errors[0].message}`);
        file.source = code;
      }
    },
  };
}

function bytesOf(source: string | Uint8Array): Uint8Array {
  return typeof source === 'string' ? new TextEncoder().encode(source) : source;
}
