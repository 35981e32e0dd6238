#!/usr/bin/env bash
# The runs that the shipped surrogate learns from, their tables and the model itself in ../data.
#   bash scheduler/surrogate/campaign/run.sh     an hour and a half on 2 cores; resumes where it stopped (build/campaign.db)
# The article's L32 in `quick` and in `standard` tells one profile from the other.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/../../../client/setup.sh"
install_missing
build_regolab -- regolab regolab-scheduler regolab-worker
db=${REGOLAB_CAMPAIGN_DB:-$root/build/campaign.db} regolab=$root/build/bin/regolab data=$here/../data
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# table design [options]: runs it, then TABLE.csv with a row per point and seed, and what it cost
ids=()
keep() {
  local table=$1 design=$2 id out=$scratch/$1
  shift 2
  "$regolab" run "$design" --db "$db" --json "$@" >"$out.json" || [ $? = 5 ]  # 5: some stages ended without numbers, which is data
  id=$(sed -n 's/^  "experiment": "\(.*\)",$/\1/p' "$out.json")
  ids+=("$id")
  "$regolab" results "$id" --csv --db "$db" >"$data/$table.csv" 2>/dev/null
  "$regolab" export "$id" -o "$out" --db "$db" >/dev/null 2>&1
  awk -F, -v table="$table" 'NR > 1 { hours += $4 / 3600; steps += $5 }
    END { printf "%s: %.2f core hours, %.0f M steps\n", table, hours, steps / 1e6 }' "$out/times.csv" >>"$scratch/cost.txt"
}

keep box "$here/box.yaml"
keep box-more "$here/box-more.yaml"
keep box-large "$here/box-large.yaml"
keep l32-quick "$root/client/examples/article-l32.yaml" --seeds 3
keep l32-standard "$root/client/examples/article-l32.yaml" --profile standard --seeds 3
cp "$scratch/cost.txt" "$data/cost.txt"
"$regolab" train "${ids[@]}" --name "article's box" -o "$data/model.json" --db "$db"
