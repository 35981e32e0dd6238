#!/usr/bin/env bash
# What do step, loading rate, stiffness, masses and size change, against the scatter between seeds?
#   bash tests/convergence/run.sh      runs what is not stored yet (about 45 minutes on 2 cores), rewrites the tables, table.md and size.svg
# Resumes where it stopped: finished stages stay in build/convergence.db.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/../../client/setup.sh"
command -v gnuplot >/dev/null || packages+=(gnuplot-nox)
install_missing
build_regolab -- regolab regolab-scheduler regolab-worker
db=${REGOLAB_CONVERGENCE_DB:-$root/build/convergence.db} regolab=$root/build/bin/regolab
for study in design:results damping:damping size:size size-8000:size-8000; do
  IFS=: read -r design table <<<"$study"
  id=$("$regolab" run "$here/$design.yaml" --db "$db" --json | sed -n 's/^  "experiment": "\(.*\)",$/\1/p') || [ $? = 5 ]
  "$regolab" results "$id" --csv --db "$db" >"$here/$table.csv" 2>/dev/null
done
plots=$(mktemp -d)
awk -v plots="$plots/size" -f "$here/table.awk" "$here/results.csv" "$here/size.csv" "$here/size-8000.csv" "$here/damping.csv" >"$here/table.md"
gnuplot -e "data='$plots/size'; out='$here/size.svg'" "$here/size.gnuplot"
rm -r "$plots"
cat "$here/table.md"
