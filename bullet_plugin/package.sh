#!/bin/sh
# Makes Debian packages: installs what is missing, builds, and leaves them in build/package. DEBFULLNAME and DEBEMAIL name
# their maintainer, as for debchange(1). Arguments go to CMake, e.g.: sh bullet_plugin/package.sh -DDGD_BUILD_DEMOS=OFF
set -eu
root=$(CDPATH='' cd "$(dirname "$0")/.." && pwd)
. "$root/demos/setup.sh"
preset=package
build_dir=$root/build/package

# shellcheck disable=SC2086 # a list of words
install_packages $build_packages
configure "$@"
build
rm -f "$build_dir"/*.deb
(cd "$build_dir" && cpack >"$build_dir/cpack.log" 2>&1) || fail "cpack could not make the packages: see $build_dir/cpack.log"
ls "$build_dir"/*.deb
