#!/usr/bin/env bash
# Repeats the paper's evaluation and writes docs/evaluation.md with its pictures (tests/evaluation/evaluate.ts).
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh test
scripts/build.sh
exec node_modules/.bin/tsx tests/evaluation/evaluate.ts
