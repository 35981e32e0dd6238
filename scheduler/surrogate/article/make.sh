#!/usr/bin/env bash
# ranges.csv, levels.csv and contrasts.csv from a database that holds both studies, fresh.csv from ../data/fresh.csv when it is there,
# then the figures from the tables.
#   bash scheduler/surrogate/article/make.sh DATABASE QUICK STANDARD     QUICK, STANDARD: the experiments' ids, as `regolab status` lists them
#   bash scheduler/surrogate/article/make.sh                             the figures alone
# campaign/run.sh makes such a database (build/campaign.db). Needs gnuplot and a built regolab.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
regolab=${REGOLAB:-$here/../../../build/bin/regolab}
if [ $# = 3 ]; then
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
  "$regolab" range --article --csv >"$scratch/article"
  "$regolab" range --article --without 3 --without 27 --csv >"$scratch/article without 3 and 27"
  "$regolab" range "$2" --db "$1" --csv >"$scratch/quick"
  "$regolab" range "$3" --db "$1" --csv >"$scratch/standard"
  cd "$scratch"
  awk -v out="$here" -f "$here/tables.awk" article "article without 3 and 27" quick standard
  if [ -f "$here/../data/fresh.csv" ]; then  # runs of campaign/fresh.yaml, which the model has not learned
    "$regolab" predict --table "$here/../campaign/points-fresh.csv" --csv >predicted
    awk -f "$here/fresh.awk" predicted "$here/../data/fresh.csv" >"$here/fresh.csv"
  fi
elif [ $# != 0 ]; then
  echo "$# arguments (three or none expected) give DATABASE QUICK STANDARD, or nothing for the figures alone" >&2
  exit 2
fi
cd "$here"
gnuplot ranges.gnuplot
gnuplot levels.gnuplot
[ ! -f fresh.csv ] || gnuplot fresh.gnuplot
