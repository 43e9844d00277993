#!/usr/bin/env bash
# Builds the WebAssembly module, the sample surfaces, the page and the command line; each only where something changed.
set -euo pipefail
cd "$(dirname "$0")/.."

for preset in wasm wasm-threads; do
    if [ ! -e "build/$preset/build.ninja" ]; then
        cmake --preset "$preset"
    fi
    cmake --build --preset "$preset"
done
node_modules/.bin/tsx web/samples/build.ts
node_modules/.bin/vite build --config web/vite.config.ts --logLevel warn
node_modules/.bin/vite build --config web/element/vite.config.ts --logLevel warn
node_modules/.bin/vite build --config web/node-cli/vite.config.ts --logLevel warn
chmod +x build/cli/meshbound.mjs # npx runs it as it is
node_modules/.bin/cem analyze --config web/element/manifest.config.mjs --quiet
