#!/bin/sh
# Installs what is missing, builds, and lets fifty polytopes fall: Bullet's narrowphase beside ours, in float and then in
# double precision. Arguments go to both runs (see `polytope_drop --help`), e.g.: sh demos/run.sh --seed 2
# Results go to out/float and out/float64, in the place of those of the last call; with --out DIR to DIR/float and
# DIR/float64, where those of another run are not replaced without --overwrite.
set -eu
root=$(CDPATH='' cd "$(dirname "$0")/.." && pwd)
. "$root/demos/setup.sh"

# Takes --out from the arguments, since each run gets a folder of its own; the others keep their order.
out=$root/out overwrite=--overwrite
left=$#
while [ "$left" -gt 0 ]; do
  argument=$1 left=$((left - 1))
  shift
  case $argument in
    --out)
      [ "$left" -gt 0 ] || fail "--out needs a folder"
      out=$1 overwrite='' left=$((left - 1))
      shift
      continue
      ;;
    --out=*) out=${argument#--out=} overwrite='' && continue ;;
  esac
  set -- "$@" "$argument"
done

# shellcheck disable=SC2086 # a list of words
install_packages $build_packages
if [ -e "$build_dir/CMakeCache.txt" ]; then
  configure
else
  configure -DDGD_BUILD_TESTS=OFF # their packages need not be here; tests/run.sh switches them on
fi
build polytope_drop polytope_drop_float64

status=0
# shellcheck disable=SC2086 # a word or none
"$build_dir/demos/polytope_drop" "$@" --out "$out/float" $overwrite || status=$?
# shellcheck disable=SC2086 # a word or none
"$build_dir/demos/polytope_drop_float64" "$@" --out "$out/float64" $overwrite || status=$?
exit "$status"
