#!/usr/bin/env bash
# Fuzzes the core for so many seconds (600 unless told), going on from what earlier runs found:
#
#     npm run fuzz -- 3600
#
# An input that breaks it is kept as build/fuzz/crash-…; give that file to build/fuzz/tests/reduce_fuzz to see it again.
set -euo pipefail
cd "$(dirname "$0")/.."

if [ ! -x build/fuzz/tests/reduce_fuzz ]; then
    cmake --preset fuzz
fi
cmake --build --preset fuzz
mkdir -p build/fuzz/corpus
build/fuzz/tests/reduce_fuzz -max_total_time="${1:-600}" -max_len=600 -timeout=20 -print_final_stats=1 -verbosity=0 \
    -artifact_prefix=build/fuzz/ build/fuzz/corpus
