#!/usr/bin/env bash
# Installs what is missing, and nothing else, so that running it again costs nothing:
#
#     scripts/setup.sh [start|test|bench|api]
#
# start: what building and serving the page needs. test (the default): what the tests and linters need as well. bench: what
# the benchmark needs. api: what makes the pages of headers and types.
set -euo pipefail
cd "$(dirname "$0")/.."

to_start=(g++ cmake ninja-build libglm-dev emscripten)
to_test=(libgtest-dev libgmock-dev libcgal-dev chromium clang libclang-rt-dev clang-format clang-tidy python3-vtk9
    python3-numpy valgrind pkgconf)
to_emulate=(g++-aarch64-linux-gnu qemu-user) # what the results on 64-bit Arm are compared by
to_bench=(libbenchmark-dev python3-vtk9 python3-numpy)

packages=("${to_start[@]}")
case "${1:-test}" in
    test)
        packages+=("${to_test[@]}")
        if [ "$(uname -m)" = x86_64 ]; then
            packages+=("${to_emulate[@]}")
        fi
        ;;
    bench) packages+=("${to_bench[@]}") ;;
    api) packages=(doxygen) ;;
esac

installed() {
    [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

missing_packages() {
    local package
    for package in "${packages[@]}"; do
        installed "$package" || echo "$package"
    done
}

install_packages() {
    local as_root=()
    if [ "$(id -u)" != 0 ]; then
        as_root=(sudo -n)
    fi
    local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=600 -q -y)
    "${apt[@]}" update
    "${apt[@]}" install --no-install-recommends "$@"
}

setup_debian() {
    local missing
    mapfile -t missing < <(missing_packages)
    if [ ${#missing[@]} = 0 ]; then
        return
    fi
    if [ "$(id -u)" != 0 ] && ! sudo -n true 2>/dev/null; then
        echo "These system packages are missing; install them with" >&2
        echo "    sudo apt-get update && sudo apt-get install --no-install-recommends ${missing[*]}" >&2
        exit 1
    fi
    echo "setup: installing ${missing[*]}"
    install_packages "${missing[@]}"
}

check_tools() {
    local missing=() tool
    for tool in c++ cmake ninja em++; do
        command -v "$tool" >/dev/null || missing+=("$tool")
    done
    if [ ${#missing[@]} != 0 ]; then
        echo "Not found: ${missing[*]}. Needed are a C++20 compiler, CMake 3.22, Ninja, GLM and Emscripten (em++ on the" >&2
        echo "PATH); for the tests also GoogleTest, CGAL, Chromium, clang-format and clang-tidy." >&2
        exit 1
    fi
}

check_node() {
    if ! node -e 'process.exit(typeof process.getBuiltinModule === "function" ? 0 : 1)'; then
        echo "Node $(node --version) is too old: 20.16 or newer is needed." >&2
        exit 1
    fi
}

check_node
if command -v dpkg-query >/dev/null; then
    setup_debian
else
    check_tools
fi

if ! node scripts/node-modules-fresh.mjs; then
    echo "setup: installing npm packages"
    npm ci --no-audit --no-fund
fi
