#!/bin/sh
# Whether builds agree to the last bit: the fifty falling polytopes for 10 s on our narrowphase, by g++ and clang++, at
# -O1 and at -O3; all without contraction (-ffp-contract=off, which
# CMakeLists.txt sets) and for the baseline instruction set. Prints each build's hash of all poses, second by second side
# by side, and the first second in which two differ.
#
#   sh tests/determinism/compare_builds.sh [BUILD_FOLDER]     builds four times: a quarter of an hour on two cores
#
# Exit status: 0 all hashes are equal; 1 some differ; anything else: a build or a run failed.
set -eu
root=$(CDPATH='' cd "$(dirname "$0")/../.." && pwd)
folder=${1:-$root/build/determinism}
mkdir -p "$folder"

build_and_run() { # COMPILER LEVEL [FLAG]
  build=$folder/$1$2
  cmake -G Ninja -S "$root" -B "$build" -DCMAKE_CXX_COMPILER="$1" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_FLAGS_RELEASE="$2 -DNDEBUG ${3-}" -DDGD_BUILD_TESTS=ON >"$build.log"
  cmake --build "$build" --target state_hash state_hash_float64 >>"$build.log"
  for program in state_hash state_hash_float64; do
    echo "$1 $2" >"$folder/$program.$1$2.txt"
    "$build/tests/determinism/$program" >>"$folder/$program.$1$2.txt"
  done
}

for compiler in g++ clang++-14; do
  build_and_run "$compiler" -O1
  build_and_run "$compiler" -O3
done

status=0
for program in state_hash state_hash_float64; do
  echo "$program"
  paste "$folder/$program.g++-O1.txt" "$folder/$program.g++-O3.txt" \
    "$folder/$program.clang++-14-O1.txt" "$folder/$program.clang++-14-O3.txt" |
    awk -F '\t' 'NR == 1 { printf "      %-18s%-18s%-18s%-18s\n", $1, $2, $3, $4; next }
      { split($1, a, "  "); line = ""; differs = 0
        for (i = 1; i <= 4; ++i) { split($i, b, "  "); line = line sprintf("%-18s", b[2]); if (b[2] != a[2]) differs = 1 }
        printf "%s  %s%s\n", a[1], line, differs ? "differ" : ""
        if (differs) worse = 1 }
      END { exit worse }' || status=1
done
exit "$status"
