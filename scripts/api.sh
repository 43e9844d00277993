#!/usr/bin/env bash
# Makes the pages of the public C++ headers (Doxygen) and of the TypeScript types (TypeDoc) in build/api. Warnings are errors:
# a link that leads nowhere, a parameter that is not there.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh api
rm -rf build/api
mkdir -p build/api

doxygen - <<'SETTINGS'
PROJECT_NAME = Meshbound
PROJECT_BRIEF = "Error-bounded reduction of triangle meshes that carry data"
INPUT = core/include/meshbound docs/cpp.md
USE_MDFILE_AS_MAINPAGE = docs/cpp.md
STRIP_FROM_INC_PATH = core/include
EXTRACT_ALL = YES
MACRO_EXPANSION = YES
EXPAND_ONLY_PREDEF = YES
PREDEFINED = MESHBOUND_API=
JAVADOC_AUTOBRIEF = YES
GENERATE_LATEX = NO
HAVE_DOT = NO
OUTPUT_DIRECTORY = build/api
HTML_OUTPUT = cpp
QUIET = YES
WARN_AS_ERROR = FAIL_ON_WARNINGS
SETTINGS

# TypeDoc reads types by a TypeScript that still has an interface for programs, so both come from npm at the moment of need.
npx --yes --package=typedoc@0.28.20 --package=typescript@5.9.3 typedoc \
    --name Meshbound --readme docs/typescript.md --out build/api/typescript \
    --excludeInternal --excludePrivate --treatWarningsAsErrors --disableSources --skipErrorChecking --logLevel Warn \
    wasm/index.ts
echo "build/api/cpp/index.html and build/api/typescript/index.html are made."
