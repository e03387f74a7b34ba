#!/bin/sh
# Instructions that a query takes, by callgrind: kinds of queries by kinds of pairs, means over 100 random pairs. They do
# not depend on what else the machine does, so that two versions of the solver can be compared to the per cent. `warm` is
# five frames, `near` the same about centres that are moved near each other, `update` and `overlap` a signed distance
# and five frames, apart and in overlap, and `alone` a signed distance without a growth distance.
#
#   sh tests/bench/query_instructions.sh      after a build; needs valgrind
set -eu
root=$(CDPATH='' cd "$(dirname "$0")/../.." && pwd)
program=${DGD_BUILD_DIR:-$root/build/release}/tests/bench/queries
if ! command -v valgrind >/dev/null || [ ! -x "$program" ]; then
  echo "error: needs valgrind, and a build with tests" >&2
  exit 1
fi
log=$(mktemp)
trap 'rm -f "$log"' EXIT

printf '%-8s %-20s %s\n' query pairs instructions
while read -r query kinds; do
  for kind in $kinds; do
    valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect='*Measured*' \
      "$program" "$query" "$kind" 2>"$log" || { cat "$log" >&2 && exit 1; }
    awk -v query="$query" -v kind="$kind" '/Collected/ { printf "%-8s %-20s %d\n", query, kind, $4 / 100 }' "$log"
  done
done <<END
growth hulls meshes capsule-hull hull-cylinder cylinders ellipsoids custom-hulls custom-ellipsoids
warm hulls meshes flat-hulls cylinders
near hulls meshes flat-hulls cylinders
check hulls capsule-hull cones
signed hulls boxes cylinders cones ellipsoids
alone hulls capsule-hull cylinders cones ellipsoids
update rounded-hulls rounded-cylinders
overlap hulls boxes
END
