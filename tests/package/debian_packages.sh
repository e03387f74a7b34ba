#!/bin/sh
# Makes the Debian packages, has lintian look at them (not with CI set), installs them, builds and runs apps with what
# they install, runs a program that knows nothing of us by dgd-bullet-run, and removes them. This changes the machine: it
# is for continuous integration and machines to throw away. Needs root. Arguments go to bullet_plugin/package.sh.
set -eu
root=$(CDPATH='' cd "$(dirname "$0")/../.." && pwd)
. "$root/demos/setup.sh"
packages='libdgd-bullet0.1 libdgd-bullet-dev dgd-bullet-tools'
made=$root/build/package
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# shellcheck disable=SC2086 # lists of words
! dpkg-query -W -f='${db:Status-Status}\n' $packages 2>/dev/null | grep -qx installed ||
  fail "some of $packages are installed here: remove them first"
# Not in continuous integration, where installing lintian takes longer than all it does.
[ -n "${CI-}" ] || install_packages lintian
# Lintian refuses addresses that no mail can reach, such as root of a machine without a domain.
DEBFULLNAME=${DEBFULLNAME:-Package Test} DEBEMAIL=${DEBEMAIL:-test@debian.org} sh "$root/bullet_plugin/package.sh" "$@"
[ -n "${CI-}" ] || lintian --allow-root --fail-on error "$made"/*.deb

DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends install "$made"/*.deb >"$work/apt.log" 2>&1 ||
  { cat "$work/apt.log" && fail "apt-get does not install the packages"; }
# shellcheck disable=SC2086 # a list of words
dpkg -L $packages | sort -u >"$work/installed"
libraries=$(dirname "$(grep '/libdgd_bullet\.so$' "$work/installed")")
for folder in libdgd-bullet-dev/dgd_core libdgd-bullet-dev/bullet_plugin dgd-bullet-tools/demos; do
  grep -qx "/usr/share/doc/$folder/README.md" "$work/installed" || fail "$folder/README.md is in no package"
done

# Eigen, which is installed here, need not be for an app of Bullet's.
for module in dgd_bullet dgd_bullet-float64; do
  ! pkg-config --print-requires --print-requires-private $module | grep -E 'eigen|dgd_core' ||
    fail "pkg-config wants Eigen for $module"
  # The compiler's own folder, given once more as a system's, would hide the C library's headers.
  ! pkg-config --cflags $module | grep -E -- '-I/usr/(lib|include( |$))' ||
    fail "pkg-config names the compiler's own folder for $module"
done
# The tests named package.* have both precisions in both ways.
sh "$root/tests/package/pkg_config.sh" "$root/tests/package/consumer" "$work/float64" "$libraries" float64 g++
cmake -S "$root/tests/package/consumer" -B "$work/cmake-float" -DPRECISION=float >/dev/null
cmake --build "$work/cmake-float" >/dev/null
ctest --test-dir "$work/cmake-float" --output-on-failure --no-tests=error

# shellcheck disable=SC2046 # a list of words
g++ -O1 "$root"/tests/preload/linked_app.cc "$root"/tests/preload/worlds.cc "$root"/tests/preload/heap.cc \
  -o "$work/app" $(pkg-config --cflags --libs bullet)
dgd-bullet-run --statistics "$work/app" one >/dev/null 2>"$work/statistics"
grep -q '"type_0": "BOX", "type_1": "BOX", "calls": [1-9]' "$work/statistics" ||
  { cat "$work/statistics" && fail "dgd-bullet-run does not reach a program"; }
if [ -e /usr/bin/polytope_drop ]; then
  (cd "$work" && polytope_drop --duration 0.5 --no-snapshots) # finds its scene where the package has it
fi

# shellcheck disable=SC2086 # a list of words
apt-get -q -y purge $packages >"$work/apt.log" 2>&1 || { cat "$work/apt.log" && fail "apt-get does not remove the packages"; }
while read -r path; do
  if [ -L "$path" ] || [ -f "$path" ]; then fail "$path is left after the packages' removal"; fi
done <"$work/installed"
[ ! -e /usr/share/dgd_bullet ] || fail "/usr/share/dgd_bullet is left after the packages' removal"
ldconfig -p | grep dgd_ && fail "the dynamic linker still knows the libraries"
echo "The packages are made, installed, used and removed."
