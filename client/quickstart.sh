#!/usr/bin/env bash
# The article's 32-test study from nothing: installs what is missing, builds, runs it on all cores, prints the range analysis
# and our results beside the article's. Safe to run again: what is stored is not computed twice. Extra words go to
# `regolab run` (for example --seeds 2).
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
cd "$root"

began=$(date +%s)
step() {
  local s=$(($(date +%s) - began))
  printf '\n[%d:%02d] %s\n' $((s / 60)) $((s % 60)) "$*" >&2
}

step "looking for missing packages"
install_missing
step "building into build/ (the first time takes some minutes)"
build_regolab -- regolab regolab-scheduler regolab-worker

database=build/article-l32.db
step "running client/examples/article-l32.yaml, profile quick, on $(nproc) cores; database $database"
code=0
build/bin/regolab run client/examples/article-l32.yaml --profile quick --db "$database" "$@" || code=$?
# 5: the study ended and some cells have a reason instead of a number; there is still something to show.
[ "$code" = 0 ] || [ "$code" = 5 ] || exit "$code"

step "range analysis, response by response"
build/bin/regolab range last --db "$database" 2>/dev/null || true

step "our results beside the article's"
build/bin/regolab article compare last --db "$database" 2>/dev/null || true

step "done. Results: $root/$database. To look around:"
cat >&2 <<EOF
  cd $root && export PATH="\$PWD/build/bin:\$PATH"
  regolab range last --response repose_angle --db $database     # R, ANOVA, fragility of one response
  regolab results last --csv -o article-l32.csv --db $database  # every number
  regolab export last -o article-l32 --db $database             # every stage with its curves
  regolab article check                                         # the article's own tables, recomputed
EOF
exit "$code"
