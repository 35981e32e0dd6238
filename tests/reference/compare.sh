#!/usr/bin/env bash
# Compares us with the independent code's four materials: `bash tests/reference/compare.sh [SEEDS [JOBS]]`, 3 seeds by default.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../../client/setup.sh"
install_missing
build_regolab -DREGOLAB_TESTS=ON -- reference_compare >&2
exec "$root/build/tests/reference_compare" "$@"
