#!/bin/sh
# Builds and runs the consumer with pkg-config and the compiler alone; and what mixes the precisions of Bullet, which
# must fail as it should.
# Usage: pkg_config.sh CONSUMER_DIR OUTPUT_DIR LIBRARY_DIR float|float64 'COMPILER [FLAG...]'
set -eu
consumer=$1 output=$2 library_dir=$3 precision=$4 compiler=$5
case $precision in
  float) module=dgd_bullet other_module=dgd_bullet-float64 other_suffix=-float64 namespace=float32 own=float other=double ;;
  float64) module=dgd_bullet-float64 other_module=dgd_bullet other_suffix='' namespace=float64 own=double other=float ;;
esac
export PKG_CONFIG_PATH="$library_dir/pkgconfig"
export LD_LIBRARY_PATH="$library_dir${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}" # if the libraries are shared
mkdir -p "$output"

build() { # PROGRAM FLAG...
  program=$1
  shift
  # shellcheck disable=SC2086 # a list of words
  $compiler "-DEXPECTED_PRECISION=\"$precision\"" "$consumer/$program.cc" -o "$output/$program" "$@"
}
build_and_run() { # PROGRAM PKG_CONFIG_ARGUMENT...
  program=$1
  shift
  # shellcheck disable=SC2046 # a list of words
  build "$program" $(pkg-config --cflags --libs "$@")
  "$output/$program"
}
fails_with() { # TEXT COMMAND...: the command fails, and what it prints contains the text
  text=$1
  shift
  if "$@" >"$output/log" 2>&1 || ! grep -qF "$text" "$output/log"; then
    cat "$output/log"
    echo "$* did not fail with: $text"
    exit 1
  fi
}

build_and_run falling_box "$module"
build_and_run falling_box "$module" --static
record=dgd_bullet_record${module#dgd_bullet}
if pkg-config --exists "$record"; then
  (cd "$output" && build_and_run recorded_pair "$record")
fi
if [ "$precision" = float ]; then # The solver alone knows no precision: once is enough.
  compiler="$compiler -std=c++20" # for the solver's headers; the plugin's do with the default
  build_and_run two_cubes dgd_core
fi

# Headers of one precision with the library of the other do not link.
# shellcheck disable=SC2046 # lists of words
fails_with "dgd_bullet::$namespace::MakeNarrowphase" \
  build falling_box $(pkg-config --cflags "$module") $(pkg-config --libs "$other_module")
# All of one precision links, but another library's Bullet may come first: the one that the process then uses.
# shellcheck disable=SC2046 # a list of words
build falling_box "-lBulletCollision$other_suffix" $(pkg-config --cflags --libs "$module")
fails_with "in $own, but the Bullet library in this process is in $other" "$output/falling_box"
