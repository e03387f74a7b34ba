#!/bin/sh
# Fuzzes: builds the targets of tests/fuzz with clang, libFuzzer and the address and undefined-behaviour sanitizers, and
# runs them for a time, one on each processor.
#
#   sh tests/fuzz.sh                             all targets, ten minutes altogether
#   sh tests/fuzz.sh --minutes 600 solver hull   two of them, for a night
#   sh tests/fuzz.sh --seeds solver              of all inputs that were kept here, the fewest that reach all edges
#                                                become tests/fuzz/corpus/solver
#
# Inputs that reach something new are kept in build/fuzz/corpus, and the next run goes on from them. A finding ends its
# target's run: it is in build/fuzz/findings, and `build/fuzz/tests/fuzz/fuzz_TARGET FILE` shows it again.
# Exit status: 0; 1 there is a finding; 2 wrong arguments.
set -eu
root=$(CDPATH='' cd "$(dirname "$0")/.." && pwd)
cd "$root"
. "$root/demos/setup.sh"
build=build/fuzz
seeds=tests/fuzz/corpus
all_targets='hull plugin_world record_file scene_file solver world_file'
# Bytes of an input, and seconds that one may take: the slowest honest one takes a tenth.
most_bytes=2048
most_seconds=20

usage() {
  sed -n '2,/^set -eu/{/^#/s/^# \{0,1\}//p}' "$0" >&2
  exit 2
}

minutes=10
task=run
targets=
while [ $# -gt 0 ]; do
  case $1 in
    --minutes)
      [ $# -ge 2 ] || usage
      case $2 in '' | *[!0-9]* | 0) usage ;; esac
      minutes=$2
      shift
      ;;
    --seeds) task=seeds ;;
    -*) usage ;;
    *)
      case " $all_targets " in *" $1 "*) targets="$targets $1" ;; *) usage ;; esac
      ;;
  esac
  shift
done
targets=${targets:-$all_targets}

# Where a target starts from; scenes are written already.
seeds_of() { # TARGET
  echo "tests/fuzz/corpus/$1"
  [ "$1" != scene_file ] || echo scenes
}

build_targets() {
  # shellcheck disable=SC2086 # a list of words
  install_packages $build_packages libgtest-dev libglpk-dev libfcl-dev doxygen clang-14 \
    libclang-rt-14-dev
  [ ! -e "$build/CMakeCache.txt" ] && command -v ninja >/dev/null && export CMAKE_GENERATOR="${CMAKE_GENERATOR:-Ninja}"
  cmake --preset fuzz >/dev/null
  # shellcheck disable=SC2046,SC2086 # a list of words
  cmake --build "$build" --parallel "$(nproc)" --target $(printf 'fuzz_%s ' $targets)
}

# One target, for so many seconds; its log is build/fuzz/TARGET.log.
run_target() { # TARGET SECONDS
  mkdir -p "$build/corpus/$1" "$build/findings"
  # shellcheck disable=SC2046 # a list of folders
  "$build/tests/fuzz/fuzz_$1" -max_total_time="$2" -max_len="$most_bytes" -timeout="$most_seconds" \
    -artifact_prefix="$build/findings/$1-" -print_final_stats=1 "$build/corpus/$1" $(seeds_of "$1") \
    >"$build/$1.log" 2>&1 </dev/null || true
}

# The smallest corpus that reaches what all inputs reach.
make_seeds() { # TARGET
  smallest=$(mktemp -d "${TMPDIR:-/tmp}/dgd-seeds.XXXXXX")
  "$build/tests/fuzz/fuzz_$1" -merge=1 -use_counters=0 -max_len="$most_bytes" "$smallest" "$build/corpus/$1" \
    "$seeds/$1" >"$build/$1.log" 2>&1
  rm -f "$seeds/$1"/*
  mv "$smallest"/* "$seeds/$1/"
  rmdir "$smallest"
  echo "$1: $(find "$seeds/$1" -type f | wc -l) seeds"
}

print_row() { # TARGET
  awk -v target="$1" '
    /INITED cov: / { sub(/.*cov: /, ""); before = $1 }
    / cov: / { line = $0; sub(/.*cov: /, "", line); split(line, words, " "); after = words[1] }
    /^stat::number_of_executed_units:/ { executions = $2 }
    /^(SUMMARY|==[0-9]+== ERROR: libFuzzer)/ { findings = 1 }
    END { printf "%-14s %12d %12d %12d %9d\n", target, executions, after, after - before, findings }' "$build/$1.log"
}

build_targets
if [ "$task" = seeds ]; then
  for target in $targets; do make_seeds "$target"; done
  exit 0
fi

# shellcheck disable=SC2086 # a list of words
set -- $targets
processors=$(nproc)
[ "$processors" -le $# ] || processors=$#
seconds=$((minutes * 60 * processors / $#))
# Each processor takes every so-manieth target, one after the other.
processor=0
while [ "$processor" -lt "$processors" ]; do
  (
    turn=0
    for target in "$@"; do
      [ $((turn % processors)) -ne "$processor" ] || run_target "$target" "$seconds"
      turn=$((turn + 1))
    done
  ) &
  processor=$((processor + 1))
done
wait

printf '%-14s %12s %12s %12s %9s\n' target executions edges 'new edges' findings
for target in "$@"; do print_row "$target"; done
for target in "$@"; do
  ! grep -Eq '^(SUMMARY|==[0-9]+== ERROR: libFuzzer)' "$build/$target.log" || exit 1
done
