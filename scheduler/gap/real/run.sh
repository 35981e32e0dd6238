#!/usr/bin/env bash
# What the diagnosis says of published figures: a table of verdicts on stdout, each answer as JSON and as a page in build/real.
#   bash scheduler/gap/real/run.sh [--bank FILE --kernels FILE]     about ten minutes on 2 cores; answers that are there are kept
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/../../../client/setup.sh"
regolab=$root/build/bin/regolab out=${REGOLAB_REAL_OUT:-$root/build/real}
[ -x "$regolab" ] || { install_missing && build_regolab -- regolab regolab-scheduler regolab-worker; } >&2
mkdir -p "$out/new"
awk -F, -v out="$out/new" -f "$here/table-9.awk" "$here/table-9.csv"
cp "$here"/*.yaml "$out/new"
for file in "$out"/new/*.yaml; do
  cmp -s "$file" "$out/$(basename "$file")" || cp "$file" "$out"
done

awk -F, -f "$here/intercept.awk" "$here/table-9.csv"
echo
echo "| figures | where | verdict | next |"
echo "|---|---|---|---|"
for file in "$out"/fjs-1.yaml "$out"/jsc-1.yaml "$out"/jsc-1a.yaml "$out"/table-9-*.yaml; do
  name=$(basename "$file" .yaml)
  answer=$out/$name.txt
  if [ ! -s "$answer" ] || [ "$file" -nt "$answer" ]; then
    echo "$name" >&2
    "$regolab" gap diagnose "$file" "$@" --report "$out/$name.html" >"$answer.part" 2>"$out/$name.log" || { cat "$out/$name.log" >&2; exit 1; }
    mv "$answer.part" "$answer"
  fi
  awk -v name="$name" '{ key = $1; $1 = ""; sub(/^ /, ""); gsub(/\|/, "/"); line[key] = $0 }
    END { printf "| %s | %s | %s | %s |\n", name, line["where"], line["which"], line["next"] }' "$answer"
done
