#!/usr/bin/env bash
# Installs the dependencies, configures, builds, and runs every test. Works from any folder, without a terminal.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
bash cmake/install-dependencies.sh
cmake --preset release -DTERRANE_BUILD_BENCHMARKS=ON
cmake --build --preset release -j "$(nproc)"
ctest --test-dir build/release --output-on-failure --no-tests=error -j 2
