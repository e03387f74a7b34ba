#!/bin/sh
# A study of 200 runs (fifty polytopes for half a second: 50 seeds, both narrowphases, float and double) carried out by one
# process, two jobs, three MPI ranks, four shards, and by a sweep that is killed three times and resumed: one line each with
# a digest of its CSV, without the columns of measured times. Results go to out/sweep_200.
set -eu
root=$(CDPATH='' cd "$(dirname "$0")/../.." && pwd)
. "$root/demos/setup.sh"

# shellcheck disable=SC2086 # lists of words
install_packages $build_packages $test_packages
# shellcheck disable=SC2119 # there are no options to pass on
configure
build headless_sim headless_sim_float64

out=$root/out/sweep_200
rm -rf "$out"
mkdir -p "$out"
cat >"$out/study.json" <<STUDY
{ "about": "Fifty polytopes.", "worlds": ["$root/scenes/polytopes_50.json"], "seeds": { "from": 1, "to": 50 },
  "narrowphases": ["builtin", "dgd"], "precisions": ["float", "double"], "duration": 0.5, "oracle_every": 60 }
STUDY
program=$build_dir/demos/headless_sim

# The columns whose names say that they are times of this machine are left out.
digest() {
  awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) is_time[i] = $i == "narrowphase_us_per_query" || $i == "wall_time_s" }
           { for (i = 1; i <= NF; ++i) if (!is_time[i]) printf "%s,", $i; print "" }' "$1/runs.csv" | sha256sum | cut -c1-16
}

sweep() {
  name=$1
  shift
  "$program" sweep "$out/study.json" --out "$out/$name" "$@" >"$out/$name.log" 2>&1
}

report() {
  printf '%-28s %4d runs  %s\n' "$2" "$(($(wc -l <"$out/$1/runs.csv") - 1))" "$(digest "$out/$1")"
}

sweep one && report one "one process"
sweep two --jobs 2 && report two "two jobs"
if command -v mpirun >/dev/null; then
  mpirun --allow-run-as-root --oversubscribe -n 3 "$program" sweep "$out/study.json" --out "$out/mpi" >"$out/mpi.log" 2>&1
  report mpi "three MPI ranks"
fi
for shard in 1 2 3 4; do sweep "shard$shard" --shard "$shard/4"; done
sweep merged --merge "$out/shard1,$out/shard2,$out/shard3,$out/shard4"
report merged "four shards"
for seconds in 5 3 7; do
  timeout -s KILL "$seconds" "$program" sweep "$out/study.json" --out "$out/killed" --jobs 2 >/dev/null 2>&1 || true
done
sweep killed --jobs 2 && report killed "killed three times, resumed"
