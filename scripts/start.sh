#!/usr/bin/env bash
# Builds the page and serves it; further arguments go to the server: npm start -- --port 8080 --host
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh start
scripts/build.sh
exec node_modules/.bin/vite preview --config web/vite.config.ts "$@"
