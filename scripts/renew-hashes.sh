#!/usr/bin/env bash
# Writes the hashes that every system must print anew (tests/hashes/expected.txt): where a change of the bytes is meant.
set -euo pipefail
cd "$(dirname "$0")/.."

cmake --preset native
cmake --build --preset native --target result_hashes
build/native/tests/hashes/result_hashes > tests/hashes/expected.txt
