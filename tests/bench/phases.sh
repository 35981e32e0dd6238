#!/usr/bin/env bash
# Where a step's time goes, phase by phase: `bash tests/bench/phases.sh [BED [options of Google Benchmark]]`, BED one of A, B, C, D1,
# A_fall (A by default).
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/../../client/setup.sh"
packages+=(libbenchmark-dev)
install_missing
build_regolab -DREGOLAB_TESTS=ON -- bench_beds bench_phases >&2
"$root/build/tests/bench_beds" "$root/build/bench/beds"
"$root/build/tests/bench_phases" "$root/build/bench/beds/${1:-A}.csv" "${@:2}"
