#!/usr/bin/env bash
# The article's own sets in DEM: sets-measured.csv (a row per set and seed) and stress-strain.csv with its figure.
#   bash scheduler/surrogate/simulants/run.sh [DATABASE]      three minutes on 2 cores; needs a built regolab and gnuplot
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$here/../../..
regolab=$root/build/bin/regolab db=${1:-$root/build/simulants.db}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$regolab" run "$here/article-sets.yaml" --db "$db" >/dev/null
"$regolab" results article-sets --csv --db "$db" >"$here/sets-measured.csv"
"$regolab" export article-sets -o "$scratch/sets" --db "$db" >/dev/null
cd "$scratch/sets"
# sigma1/sigma3 against axial strain per cent, the mean of the seeds
awk -F, 'BEGIN { print "set,sigma3_kPa,axial_strain_percent,sigma1_over_sigma3" }
  FNR == 1 { split(FILENAME, part, "/"); set = substr(part[1], 7) + 0; stress = part[3]; sub(/stress_/, "", stress); sub(/kPa.*/, "", stress); next }
  { key = set "," stress "," sprintf("%.2f", 100 * $1); sum[key] += $2 / stress; n[key]++ }
  END { for (key in sum) print key "," sprintf("%.4f", sum[key] / n[key]) }' point-*/seed-*/stress_*-sigma1_at_*.csv |
  { read -r header; echo "$header"; sort -t, -k1,1n -k2,2n -k3,3n; } >"$here/stress-strain.csv"
cd "$here"
gnuplot stress-strain.gnuplot
