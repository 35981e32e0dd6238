#!/usr/bin/env bash
# The runs that the shipped surrogates learn from, and their tables in ../data.
#   bash scheduler/surrogate/campaign/run.sh     about an hour and a half on 2 cores; resumes where it stopped
# Finished stages stay in build/campaign.db. The same article's L32 in `standard` and in `quick` gives the fidelity correction.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/../../../client/setup.sh"
install_missing
build_regolab -- regolab regolab-scheduler regolab-worker
db=${REGOLAB_CAMPAIGN_DB:-$root/build/campaign.db} regolab=$root/build/bin/regolab data=$here/../data
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# table design [options]: runs it, then TABLE.csv (a row per point and seed) and TABLE-curves.csv (sigma1 on a grid of axial strain)
keep() {
  local table=$1 design=$2 id out=$scratch/$1
  shift 2
  "$regolab" run "$design" --db "$db" --json "$@" >"$out.json" || [ $? = 5 ]  # 5: some stages ended without numbers, which is data
  id=$(sed -n 's/^  "experiment": "\(.*\)",$/\1/p' "$out.json")
  "$regolab" results "$id" --csv --db "$db" >"$data/$table.csv" 2>/dev/null
  "$regolab" export "$id" -o "$out" --db "$db" >/dev/null 2>&1
  awk -f "$here/curves.awk" "$out"/point-*/seed-*/stress_*kPa-sigma1_at_*.csv >"$data/$table-curves.csv"
  awk -F, 'NR > 1 { hours += $4 / 3600; steps += $5 } END { printf "%.2f core hours, %.1f M steps\n", hours, steps / 1e6 }' "$out/times.csv" \
    >"$data/$table-cost.txt"
}

keep box "$here/box.yaml"
keep l32-quick "$root/client/examples/article-l32.yaml" --seeds 3
keep l32-standard "$root/client/examples/article-l32.yaml" --seeds 3 --profile standard
