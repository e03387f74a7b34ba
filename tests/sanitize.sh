#!/bin/sh
# The tests with sanitizers, by clang or whatever CXX says.
#
#   sh tests/sanitize.sh asan [CTEST ARGUMENTS]   the whole suite: address and undefined behaviour; an hour
#   sh tests/sanitize.sh quick [CTEST ARGUMENTS]  of it the plugin's tests in float and the quicker fuzzers' corpus, with
#                                                 shared libraries, and without what the tests' own code does; minutes
#   sh tests/sanitize.sh tsan [CTEST ARGUMENTS]   the tests with threads, and a scene of 250 bodies on two of them
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
    options='-DBUILD_SHARED_LIBS=OFF -DDGD_SANITIZE_TESTS=ON'
    ;;
  quick)
    # The solver is in the plugin. Its own fuzzer, for all types and both scalars, takes as long to build as all of this.
    preset=asan-ubsan
    targets='test_plugin_float test_plugin_float_memory fuzz_hull fuzz_plugin_world fuzz_record_file'
    tests='test_plugin_float(_memory)?\.|fuzz_(hull|plugin_world|record_file)|exports\.dgd_(core|bullet)$'
    # Errors are looked for in the libraries and the fuzz targets: the tests' own code takes twice as long to compile
    # with sanitizers as without.
    options='-DBUILD_SHARED_LIBS=ON -DDGD_SANITIZE_TESTS=OFF'
    # One of two ways to register; and without the longest of those that measure how still bodies lie, how far they roll
    # or how deep they are, which is no matter of memory.
    still='SharedManifold.BoxesOn*Mesh*:MeshContacts.BodiesOnAFineMesh*:FrictionAnchors.Pyramid*:HullsOnMesh.LeanHull*'
    moving='MeshContacts.RollingBall*:MeshContacts.SlidingBody*:Experiments/*:PairHistory.BodiesThatComeNearer*'
    export GTEST_FILTER="${GTEST_FILTER:--AllTypes/*_Register:Routes/*/Register:$still:$moving}"
    ;;
  tsan)
    preset=tsan
    targets='test_plugin_float test_soak big_scenes'
    tests='test_plugin_float\.|test_soak|big_scenes_threads'
    options=
    # Of the plugin's tests, those with threads.
    export GTEST_FILTER="${GTEST_FILTER:-CollisionDispatcher*:Threads*:DgdSoak*}"
    ;;
  *)
    sed -n '2,/^set -eu/{/^#/s/^# \{0,1\}//p}' "$0" >&2
    exit 2
    ;;
esac
shift

# shellcheck disable=SC2086 # a list of words
install_packages $build_packages libgtest-dev libglpk-dev libfcl-dev doxygen clang-14 libclang-rt-14-dev
build_dir=$root/build/$preset
if [ ! -e "$build_dir/CMakeCache.txt" ]; then
  export CXX="${CXX:-clang++-14}" CC="${CC:-clang-14}"
fi
# shellcheck disable=SC2086 # lists of words
configure -DDGD_BUILD_TESTS=ON $options ${CI:+-DDGD_WERROR=ON}
# shellcheck disable=SC2086 # a list of words
build $targets
exec ctest --test-dir "$build_dir" --output-on-failure --no-tests=error --parallel "$(nproc)" --tests-regex "$tests" "$@"
