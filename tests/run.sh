#!/bin/sh
# Installs what is missing, builds everything and runs all tests. Arguments go to ctest, e.g.: sh tests/run.sh -R package
# With CI set, warnings are errors.
set -eu
root=$(CDPATH='' cd "$(dirname "$0")/.." && pwd)
. "$root/demos/setup.sh"

# shellcheck disable=SC2086 # lists of words
install_packages $build_packages $test_packages
configure -DDGD_BUILD_TESTS=ON ${CI:+-DDGD_WERROR=ON}
build
exec ctest --test-dir "$build_dir" --output-on-failure --no-tests=error --parallel "$(nproc)" "$@"
