#!/usr/bin/env bash
# Measures the speed beside other tools (tests/bench/bench.ts; docs/speed.md has a table): npm run bench -- --quick
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh bench
exec node_modules/.bin/tsx tests/bench/bench.ts "$@"
