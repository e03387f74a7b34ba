#!/bin/sh
# Runs an app on Debian's DART, whose Bullet is in float, by dgd-bullet-run: one in C++, which is compiled here, or one
# in Python. Exit status 77, and a reason, where DART is not installed.
# Usage: dart_test.sh DGD_BULLET_RUN dart_app.cc|dart_app.py OUTPUT_DIR 'COMPILER [FLAG...]'
set -eu
run=$1 source=$2 output=$3 compiler=$4
python=/usr/bin/python3 # Debian's modules are for Debian's interpreter.
mkdir -p "$output"
cd "$output"

skip() {
  echo "skipped: $1"
  exit 77
}
case $source in
  *.py)
    "$python" -c 'import dartpy' 2>err || skip "python3-dartpy is not installed: $(tail -n 1 err)"
    set -- "$python" "$source"
    ;;
  *.cc)
    echo '#include <dart/collision/bullet/bullet.hpp>' >header.cc
    # shellcheck disable=SC2046,SC2086 # lists of words
    $compiler $(pkg-config --cflags dart bullet 2>err) -E header.cc >header.out 2>>err ||
      skip "libdart-collision-bullet-dev is not installed: $(grep -m 1 -E "No such file|not found" err)"
    # shellcheck disable=SC2046,SC2086 # lists of words
    $compiler $(pkg-config --cflags dart bullet) -std=c++17 "$source" -o dart_app $(pkg-config --libs dart) \
      -ldart-collision-bullet $(pkg-config --libs bullet)
    set -- ./dart_app
    ;;
esac

"$@" >plain
"$run" --statistics "$@" >ours 2>statistics || {
  cat ours statistics
  exit 1
}
grep -q '"type_0": "BOX", "type_1": "BOX", "calls": [1-9]' statistics || {
  cat statistics
  exit 1
}
DGD_BULLET_OFF=1 "$run" "$@" >off
cmp plain off
"$run" --audit "$@" >audited 2>audit
cmp plain audited
grep -q '^BOX and BOX, [1-9]' audit
