#!/usr/bin/env bash
# Style and likely mistakes: Biome for TypeScript, clang-format and clang-tidy for C++. Every linter runs, then it fails.
set -uo pipefail
cd "$(dirname "$0")/.."

status=0

echo "lint: Biome"
node_modules/.bin/biome ci . || status=1

echo "lint: clang-format"
mapfile -t cpp < <(find core examples tests wasm web -name '*.cpp' -o -name '*.hpp')
clang-format --dry-run --Werror "${cpp[@]}" || status=1

echo "lint: clang-tidy"
if [ ! -e build/native/compile_commands.json ]; then
    cmake --preset native || exit 1
fi
run-clang-tidy -quiet -p build/native "$PWD/core/src/.*" 2>&1 | grep -v 'warnings generated' || true
[ "${PIPESTATUS[0]}" = 0 ] || status=1

exit $status
