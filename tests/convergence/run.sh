#!/usr/bin/env bash
# What do half the step, half the loading rate and twice the clusters change, against the scatter between seeds?
#   bash tests/convergence/run.sh      runs what is not stored yet (about 15 minutes on 2 cores), rewrites results.csv and table.md
# Resumes where it stopped: finished stages stay in build/convergence.db.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/../../client/setup.sh"
install_missing
build_regolab -- regolab regolab-scheduler regolab-worker
regolab=$root/build/bin/regolab
db=$root/build/convergence.db
"$regolab" run "$here/design.yaml" --db "$db" >/dev/null
"$regolab" results last --csv --db "$db" >"$here/results.csv" 2>/dev/null
awk -f "$here/table.awk" "$here/results.csv" >"$here/table.md"
cat "$here/table.md"
