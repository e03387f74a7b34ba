#!/bin/sh
# Builds the plugin and an app against each Bullet, found in each way, with each compiler, runs the app, and prints a
# table. Bullet's sources are Debian's, fetched from its archive without a change to the system. Half an hour on 2 cores.
#
#   sh tests/package/bullet_matrix.sh [WORK_DIR]    default: a new folder, removed at the end
#
# COMPILERS: those to build with; default: g++ and clang++-14, if there. Exit status: 0 all works; 1 something does not.
set -eu
source=$(CDPATH='' cd "$(dirname "$0")/../.." && pwd)
if [ $# -gt 0 ]; then
  mkdir -p "$1"
  work=$(CDPATH='' cd "$1" && pwd)
else
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
fi
if [ -z "${COMPILERS:-}" ]; then
  COMPILERS=g++
  ! command -v clang++-14 >/dev/null || COMPILERS="$COMPILERS clang++-14"
fi
if command -v ninja >/dev/null; then
  export CMAKE_GENERATOR=Ninja
fi
if command -v ccache >/dev/null; then
  export CMAKE_CXX_COMPILER_LAUNCHER=ccache CMAKE_C_COMPILER_LAUNCHER=ccache
fi
export CMAKE_BUILD_PARALLEL_LEVEL="${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}"

fetch_bullet() {
  mkdir -p "$work/apt/partial" "$work/source"
  (
    cd "$work/source"
    # shellcheck source=/dev/null
    . /etc/os-release
    key=/usr/share/keyrings/debian-archive-keyring.gpg
    echo "deb-src [signed-by=$key] http://deb.debian.org/debian $VERSION_CODENAME main" >"$work/apt.list"
    set -- -o "Dir::Etc::SourceList=$work/apt.list" -o Dir::Etc::SourceParts=/dev/null -o "Dir::State::Lists=$work/apt" \
      -o APT::Sandbox::User=root
    apt-get "$@" update
    apt-get "$@" source --download-only bullet
    tar -xf bullet_*.orig.tar.*
  ) >"$work/fetch.log" 2>&1 || {
    cat "$work/fetch.log" >&2
    echo "error: Bullet's sources cannot be fetched" >&2
    exit 1
  }
}

install_bullet() { # NAME OPTION...
  name=$1
  shift
  cmake -S "$bullet" -B "$work/bullet_$name" -DCMAKE_BUILD_TYPE=Release "$@" \
    "-DCMAKE_INSTALL_PREFIX=$work/prefix_$name" -DINSTALL_LIBS=ON -DBUILD_SHARED_LIBS=ON -DBUILD_BULLET2_DEMOS=OFF \
    -DBUILD_BULLET3=OFF -DBUILD_CPU_DEMOS=OFF -DBUILD_EXTRAS=OFF -DBUILD_OPENGL3_DEMOS=OFF -DBUILD_PYBULLET=OFF \
    -DBUILD_UNIT_TESTS=OFF -DUSE_GLUT=OFF && cmake --build "$work/bullet_$name" --target install
}

# An app against the installed package, which was built against the Bullet in a prefix; Debian's if that is empty.
build_by_package() { # NAME PRECISION COMPILER BULLET_ROOT
  cmake -S "$source" -B "$work/$1/plugin" -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_COMPILER=$3" -DDGD_BUILD_DEMOS=OFF \
    -DDGD_BUILD_TESTS=OFF "-DBullet_ROOT=$4" "-DCMAKE_INSTALL_PREFIX=$work/$1/installed" &&
    cmake --build "$work/$1/plugin" --target install &&
    cmake -S "$source/tests/package/consumer" -B "$work/$1/app" "-DCMAKE_CXX_COMPILER=$3" -DCMAKE_BUILD_TYPE=Release \
      "-DCMAKE_PREFIX_PATH=$work/$1/installed" "-DPRECISION=$2" &&
    cmake --build "$work/$1/app" && "$work/$1/app/falling_box" &&
    { [ ! -e "$work/$1/app/many_threads" ] || "$work/$1/app/many_threads"; }
}

build_in_tree() { # NAME PRECISION COMPILER
  double=OFF
  [ "$2" = float ] || double=ON
  cmake -S "$source/tests/package/in_tree" -B "$work/$1" -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_COMPILER=$3" \
    "-DUSE_DOUBLE_PRECISION=$double" "-DBULLET_DIR=$bullet" "-DDGD_DIR=$source" &&
    cmake --build "$work/$1" --target falling_box && "$work/$1/falling_box"
}

status=0
build_and_run() { # NAME WAY PRECISION COMPILER [BULLET_ROOT]
  case $2 in
    'in the build') build_in_tree "$1" "$3" "$4" ;;
    *) build_by_package "$1" "$3" "$4" "$5" ;;
  esac
}
row() { # WAY PRECISION COMPILER [BULLET_ROOT]
  way=$1 precision=$2 compiler=$3
  begin=$(date +%s)
  name=$(echo "${way}_${precision}_$compiler" | tr ' ' _)
  if build_and_run "$name" "$@" >"$work/$name.log" 2>&1; then
    outcome=$(tail -n 1 "$work/$name.log")
  else
    outcome="FAILS: $(grep -m 1 -i error "$work/$name.log" || tail -n 1 "$work/$name.log")"
    status=1
  fi
  printf '%-12s %-8s %-11s %5d s  %s\n' "$way" "$precision" "$compiler" $(($(date +%s) - begin)) "$outcome"
}

fetch_bullet
bullet=$(find "$work/source" -mindepth 1 -maxdepth 1 -type d)
printf '%-12s %-8s %-11s %7s  %s\n' Bullet precision compiler time 'what the app prints'
{
  install_bullet float && install_bullet float64 -DUSE_DOUBLE_PRECISION=ON &&
    install_bullet threads -DBULLET2_MULTITHREADING=ON
} >"$work/bullet.log" 2>&1 || {
  tail -n 20 "$work/bullet.log" >&2
  exit 1
}
for compiler in $COMPILERS; do
  for precision in float float64; do
    row "Debian's" "$precision" "$compiler" ''
    row 'a prefix' "$precision" "$compiler" "$work/prefix_$precision"
    row 'in the build' "$precision" "$compiler"
  done
  row 'threads' float "$compiler" "$work/prefix_threads"
done
exit "$status"
