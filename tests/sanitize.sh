#!/bin/sh
# The tests with sanitizers, by clang or whatever CXX says.
#
#   sh tests/sanitize.sh asan [CTEST ARGUMENTS]   the whole suite: address and undefined behaviour; an hour
#   sh tests/sanitize.sh tsan [CTEST ARGUMENTS]   the tests with threads, and a heap of 1000 bodies on two of them
#
# Exit status: 0; 1 a test failed or cannot be built; 2 wrong arguments.
set -eu
root=$(CDPATH='' cd "$(dirname "$0")/.." && pwd)
. "$root/demos/setup.sh"

case ${1-} in
  asan)
    preset=asan-ubsan
    targets=
    tests=.
    ;;
  tsan)
    preset=tsan
    targets='test_plugin_float test_soak thread_scaling'
    tests='test_plugin_float$|test_soak|thread_scaling'
    # Of the plugin's tests, those with threads.
    export GTEST_FILTER="${GTEST_FILTER:-Threads*:DgdSoak*}"
    ;;
  *)
    sed -n '2,/^set -eu/{/^#/s/^# \{0,1\}//p}' "$0" >&2
    exit 2
    ;;
esac
shift

# shellcheck disable=SC2086 # a list of words
install_packages $build_packages libgtest-dev libglpk-dev libfcl-dev libbenchmark-dev doxygen clang-14 libclang-rt-14-dev
build_dir=$root/build/$preset
if [ ! -e "$build_dir/CMakeCache.txt" ]; then
  export CXX="${CXX:-clang++-14}" CC="${CC:-clang-14}"
  ! command -v ninja >/dev/null || export CMAKE_GENERATOR="${CMAKE_GENERATOR:-Ninja}"
fi
cmake -S "$root" --preset "$preset" -DDGD_BUILD_TESTS=ON >/dev/null
# shellcheck disable=SC2086 # a list of words
build $targets
exec ctest --test-dir "$build_dir" --output-on-failure --no-tests=error --parallel "$(nproc)" --tests-regex "$tests" "$@"
