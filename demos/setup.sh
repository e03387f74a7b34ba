# shellcheck shell=sh
# What demos/run.sh, tests/run.sh and other scripts share: installing what is missing, configuring, building. Sourced by
# them; they set `root`, the project's folder, first, and may set another preset and build folder afterwards.
# shellcheck disable=SC2034,SC2154 # lists of packages are for them, root from them

build_packages='build-essential cmake ninja-build pkg-config libbullet-dev libbullet-extras-dev libeigen3-dev
  libqhull-dev libassimp-dev libosmesa6-dev libpng-dev nlohmann-json3-dev libcli11-dev'
test_packages='libgtest-dev libglpk-dev libfcl-dev libompl-dev libopenmpi-dev openmpi-bin python3-numpy doxygen'
preset=release
build_dir=${DGD_BUILD_DIR:-$root/build/release}

# A root shell made by plain `su` does not have these, and dpkg needs them.
PATH=$PATH:/usr/sbin:/sbin

fail() {
  echo "error: $*" >&2
  exit 1
}

missing_packages() {
  for package in "$@"; do
    dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || printf '%s ' "$package"
  done
}

# Installs those of the named Debian packages that dpkg does not list as installed; asks for nothing if there are none.
install_packages() {
  missing=$(missing_packages "$@")
  [ -n "$missing" ] || return 0
  command -v apt-get >/dev/null ||
    fail "there is no apt-get here to install what is missing (as Debian names it): $missing"
  as_root=
  if [ "$(id -u)" -ne 0 ]; then
    sudo true 2>/dev/null ||
      fail "this needs root or sudo to install what is missing; as root, run: apt-get install $missing"
    as_root=sudo
  fi
  log=$(mktemp "${TMPDIR:-/tmp}/dgd-apt.XXXXXX")
  echo "Installing with apt-get: $missing"
  # What `update` returns says little (0 without a network, an error for one bad source of many): installing tells.
  # shellcheck disable=SC2086 # a list of words
  {
    $as_root apt-get -q update
    $as_root env DEBIAN_FRONTEND=noninteractive \
      apt-get -q -y --no-install-recommends -o DPkg::Lock::Timeout=300 install $missing
  } >"$log" 2>&1 </dev/null ||
    fail "apt-get could not install what is missing (is there a network?); its own words are in $log"
  rm -f "$log"
}

# Configures the preset's build, with further options of CMake's. Only warnings and errors are shown.
configure() {
  if command -v ninja >/dev/null; then
    # Only for a build folder that is new: an existing one keeps its generator.
    export CMAKE_GENERATOR="${CMAKE_GENERATOR:-Ninja}"
  fi
  cmake -S "$root" --preset "$preset" "$@" >/dev/null
}

# Builds the named targets; all of them if none is named.
build() {
  if [ $# -gt 0 ]; then
    set -- --target "$@"
  fi
  cmake --build "$build_dir" --parallel "$(nproc)" "$@"
}
