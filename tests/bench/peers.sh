#!/usr/bin/env bash
# Us beside LAMMPS, on the same beds, in the same minutes: `bash tests/bench/peers.sh [ROUNDS [STEPS]]`, 3 rounds by default.
# STEPS replaces the steps of every case. Three minutes on a quiet machine, one more the first time for the beds; every run is a
# row of build/bench/peers.csv.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/../../client/setup.sh"
rounds=${1:-3} steps_for_all=${2:-}
if ! [[ $rounds =~ ^[1-9][0-9]*$ && ${steps_for_all:-1} =~ ^[1-9][0-9]*$ ]]; then
  echo "peers.sh: [ROUNDS [STEPS]] = $* (must be whole numbers above 0) try: bash tests/bench/peers.sh 3" >&2
  exit 2
fi
command -v lmp >/dev/null || packages+=(lammps)
install_missing
build_regolab -DREGOLAB_TESTS=ON -- bench_beds bench_step bench_peak >&2
programs=$root/build/tests beds=$root/build/bench/beds rows=$root/build/bench/peers.csv
"$programs/bench_beds" "$beds"
export OMP_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1  # Debian's lmp is linked with Open MPI

# case, LAMMPS's integrator, LAMMPS's skin [m] (its best), steps
cases=("A rigid 2e-4 10000" "B rigid 2e-4 10000" "C rigid 2e-4 2000" "D1 sphere 5e-4 10000" "A_fall rigid 2e-4 4000")

value() { sed -n "s/.*\b$1=\([^ ]*\).*/\1/p"; }  # of KEY in a line of key=value

run_lammps() {  # case body skin steps
  local out
  out=$(lmp -log none -in "$here/bed.lammps" -var data "$beds/$1.data" -var body "$2" -var skin "$3" -var steps "$4") || {
    echo "$out" | tail -5 >&2
    return 1
  }
  awk -v row="$round,$1,lammps,1,$4" '
    /^Loop time of/ { wall = $4; steps = $9 }   # the last loop is the timed one; its share of a core follows
    /% CPU use/ { share = $1 / 100 }
    /^result/ { split($2, contacts, "="); split($3, kinetic, "=") }
    END { printf "%s,%.3f,%.3f,%s,,%s\n", row, 1e6 * wall / steps, 1e6 * wall * share / steps, contacts[2], kinetic[2] }' <<<"$out"
}

run_ours() {  # case steps threads
  local line
  line=$("$programs/bench_step" "$beds/$1.csv" --steps "$2" --threads "$3")
  echo "$round,$1,regolab,$3,$2,$(value wall_us <<<"$line"),$(value cpu_us <<<"$line"),$(value contacts <<<"$line"),$(
    value wall_contacts <<<"$line"),$(value kinetic_J <<<"$line")"
}

note() { echo "peers: round $round of $rounds, $*" >&2; }

echo "round,case,code,threads,steps,wall_us,cpu_us,contacts,wall_contacts,kinetic_J" >"$rows"
for ((round = 1; round <= rounds; ++round)); do
  echo "$round,peak,,1,,,$("$programs/bench_peak" | value gflops),,," >>"$rows"
  for words in "${cases[@]}"; do
    read -r bed body skin steps <<<"$words"
    steps=${steps_for_all:-$steps}
    note "$bed, $steps steps: LAMMPS"
    run_lammps "$bed" "$body" "$skin" "$steps" >>"$rows"
    note "$bed, $steps steps: ours"
    run_ours "$bed" "$steps" 1 >>"$rows"
  done
  note "C on two threads"
  run_ours C "${steps_for_all:-2000}" 2 >>"$rows"
done
awk -f "$here/peers.awk" "$rows"
echo
echo "command  bash tests/bench/peers.sh $rounds${steps_for_all:+ $steps_for_all}"
cpu=$(sed -n "/^model name/{s/^[^:]*: //p;q}" /proc/cpuinfo) version=$(grep -m1 -o "Simulator - .*" <<<"$(lmp -h)")
echo "machine  $cpu, $(nproc --all) cores; LAMMPS ${version#Simulator - }"
echo "rows     $rows"
