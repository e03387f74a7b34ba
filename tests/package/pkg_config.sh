#!/bin/sh
# Builds and runs the consumer with pkg-config and the compiler alone.
# Usage: pkg_config.sh CONSUMER_DIR OUTPUT_DIR LIBRARY_DIR float|float64 'COMPILER [FLAG...]'
set -eu
consumer=$1 output=$2 library_dir=$3 precision=$4 compiler=$5
case $precision in
  float) module=dgd_bullet ;;
  float64) module=dgd_bullet-float64 ;;
esac
export PKG_CONFIG_PATH="$library_dir/pkgconfig"
export LD_LIBRARY_PATH="$library_dir${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}" # if the libraries are shared
mkdir -p "$output"

build_and_run() { # PROGRAM MODULE [--static]
  program=$1
  shift
  flags=$(pkg-config --cflags --libs "$@")
  # shellcheck disable=SC2086 # lists of words
  $compiler "-DEXPECTED_PRECISION=\"$precision\"" "$consumer/$program.cc" -o "$output/$program" $flags
  "$output/$program"
}
build_and_run falling_box "$module"
build_and_run falling_box "$module" --static
if [ "$precision" = float ]; then # The solver alone knows no precision: once is enough.
  compiler="$compiler -std=c++20" # for the solver's headers; the plugin's do with the default
  build_and_run two_cubes dgd_core
fi
