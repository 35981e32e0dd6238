#!/usr/bin/env bash
# Installs what is missing, builds, runs the tests. `bash tests/run.sh -L fast` runs one tier (arguments go to ctest).
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../client/setup.sh"
install_missing
build_regolab -DREGOLAB_TESTS=ON
cd "$root/build"
exec ctest --output-on-failure -j "$(nproc)" "$@"
