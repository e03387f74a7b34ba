#!/bin/sh
# Ten worlds as other programs make them, written by Bullet's own serializer: each on Bullet's narrowphase and on ours, in
# float and in double, with a table each. Results go to out/bullet_worlds. Arguments go to both sweeps (see `headless_sim
# sweep --help`), e.g.: sh tests/demos/bullet_worlds.sh --jobs 2
set -eu
root=$(CDPATH='' cd "$(dirname "$0")/../.." && pwd)
. "$root/demos/setup.sh"

# shellcheck disable=SC2086 # lists of words
install_packages $build_packages $test_packages
configure -DDGD_BUILD_TESTS=ON
build headless_sim headless_sim_float64 write_bullet_worlds_float write_bullet_worlds_float64

status=0
for precision in float double; do
  suffix=''
  writer=write_bullet_worlds_float
  [ "$precision" = float ] || suffix=_float64 writer=write_bullet_worlds_float64
  folder=$root/out/bullet_worlds/$precision
  "$build_dir/tests/demos/$writer" "$folder"
  worlds=$(find "$folder" -name '*.bullet' -printf '"%f"\n' | sort | paste -sd, -)
  cat >"$folder/study.json" <<STUDY
{ "about": "Worlds by Bullet's own serializer.", "worlds": [$worlds], "narrowphases": ["builtin", "dgd"], "duration": 10 }
STUDY
  "$build_dir/demos/headless_sim$suffix" sweep "$folder/study.json" --out "$folder/sweep" "$@" || status=$?
done
exit "$status"
