#!/usr/bin/env bash
# The bank of DEM runs that emulators of the gap diagnosis learn from: materials without any effect and,
# for each effect, 32 of them with it, or twice or three times that where its emulator errs most; 72 in specimens
# of other sizes. Written to ../data/bank.csv with what it cost.
#   bash scheduler/gap/bank/run.sh [--sigma3 '1.25 2.5 5 10'] [-o bank.csv]
# Four and a half hours on 2 cores, of which breakage takes one and a half (its fragments are light: seven times the steps); resumes where it
# stopped (build/campaign.db). Other confining stresses [kPa] than the shipped bank's make a bank for `gap diagnose --bank`: what is stored is
# not run again, so one more stress costs about a quarter of an hour.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
out=$here/../data/bank.csv sigma3=
while [ $# -gt 0 ]; do
  case $1 in
    --sigma3) [[ ${2:-} =~ ^[0-9.]+(\ [0-9.]+)*$ ]] || { echo "--sigma3 '${2:-}' (no list of stresses in kPa) write e.g. --sigma3 '1.25 2.5 5 10 50'" >&2; exit 2; }
      sigma3=$2; shift 2 ;;
    -o) out=${2:?"-o without a name (the bank goes to a file) write -o bank.csv"}; shift 2 ;;
    *) echo "unknown word $1 (known: --sigma3, -o) see the head of $0" >&2; exit 2 ;;
  esac
done
if [ -n "$sigma3" ] && [ "$out" = "$here/../data/bank.csv" ]; then
  echo "--sigma3 without -o (the shipped bank has stresses of its own) add -o bank.csv" >&2
  exit 2
fi
source "$here/../../../client/setup.sh"
install_missing
build_regolab -- regolab regolab-scheduler regolab-worker
db=${REGOLAB_CAMPAIGN_DB:-$root/build/campaign.db} regolab=$root/build/bin/regolab
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# design FILE: in scratch, with the stresses asked for and tables that are found from there
design() {
  local list=${sigma3// / kPa, }
  sed -e "s#{table: \.\./\.\./#{table: $here/../../#" ${list:+-e "s/sigma3: \[.*\]/sigma3: [$list kPa]/"} "$1" >"$scratch/$(basename "$1")"
  echo "$scratch/$(basename "$1")"
}

# study design [options]: runs it and keeps its id
ids=()
study() {
  local design=$1
  shift
  "$regolab" run "$design" --db "$db" --json "$@" >"$scratch/out.json" || [ $? = 5 ]  # 5: some stages ended without numbers, which is data
  ids+=("$(sed -n 's/^  "experiment": "\(.*\)",$/\1/p' "$scratch/out.json")")
}

# effect column low high log offset phase: a study of one effect over its prior range, on every sixth material from an offset on
effect() {
  local name=${1%%_kPa}
  awk -F, -v effect="$1" -v low="$2" -v high="$3" -v by_ratio="$4" -v offset="$5" -v phase="$6" -f "$here/points.awk" "$here/../../surrogate/campaign/points.csv" >"$scratch/$name.csv"
  sed "s/EFFECT/$name/g" "$(design "$here/effect.yaml")" >"$scratch/$name.yaml"
  study "$scratch/$name.yaml"
}

# size name particles every offset: the base model in specimens of that many particles, on every so manyth material from an offset on
size() {
  awk -F, -v every="$3" -v offset="$4" 'NR == 1 || (NR - 2) % every == offset' "$here/../../surrogate/campaign/points.csv" >"$scratch/$1.csv"
  sed -e "s/SIZE/$1/g" -e "s/NUMBER/$2/" "$(design "$here/size.yaml")" >"$scratch/$1.yaml"
  study "$scratch/$1.yaml"
}

study "$(design "$here/null.yaml")"
for pass in 0.5 0.25 0.75; do
  while read -r column low high by_ratio first second third; do
    case $pass in 0.5) offset=$first ;; 0.25) offset=$second ;; *) offset=$third ;; esac
    [ "$offset" = - ] || effect "$column" "$low" "$high" "$by_ratio" "$offset" "$pass" </dev/null
  done <<'EFFECTS'
cohesion_kPa 0.02 20 1 0 3 5
rolling_resistance 0.02 0.5 1 1 4 2
boundary_compliance 1 50 1 2 5 -
lateral_stress_offset_kPa -0.8 5 0 3 0 -
wall_friction 0.05 0.8 1 4 1 0
size_distribution -1 1.3 0 5 2 4
loading_rate 0.3 1.5 0 0 3 1
hertzian_contact 0.05 1 0 1 4 -
preparation_friction 0.1 0.9 0 2 5 -
preparation_gravity -1 1 0 4 1 -
breakage 0.1 50 1 3 - -
EFFECTS
done
size small 200 4 1
size large 500 8 3
"$regolab" gap bank "${ids[@]}" -o "$out" --db "$db"
