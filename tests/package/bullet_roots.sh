#!/bin/sh
# Bullets that are not Debian's whole: one precision alone, in a prefix of its own, as a build from source leaves it. Such
# prefixes are made of the system's files. The build must find what is there and say so, and an app that is built against
# the installed package must get the Bullet that it names, or a sentence.
# Usage: bullet_roots.sh SOURCE_DIR WORK_DIR INSTALLED_PREFIX COMPILER
set -eu
source=$1 work=$2 installed=$3 compiler=$4

rm -rf "$work"
include=$(pkg-config --variable=includedir bullet)
libraries=$(pkg-config --variable=libdir bullet)
make_root() { # NAME SUFFIX
  mkdir -p "$work/$1/include" "$work/$1/lib"
  cp -R "$include" "$work/$1/include/bullet"
  for library in BulletCollision LinearMath BulletDynamics; do
    cp -L "$libraries/lib$library$2.so" "$work/$1/lib/lib$library.so"
  done
}
make_root float ''
make_root float64 -float64
cp -R "$work/float64" "$work/later"
version=$work/later/include/bullet/LinearMath/btScalar.h
sed 's/^#define BT_BULLET_VERSION .*/#define BT_BULLET_VERSION 999/' "$version" >"$version.new"
mv "$version.new" "$version"

prints() { # TEXT COMMAND...: the command prints the text, whether it succeeds or not
  text=$1
  shift
  "$@" >"$work/log" 2>&1 || true
  printed "$text" || {
    echo "$* did not"
    exit 1
  }
}
printed() { # TEXT: the command that prints() ran last printed this, too; CMake breaks lines
  tr -s ' \n' ' ' <"$work/log" | grep -qF "$1" || {
    cat "$work/log"
    echo "not printed: $1"
    return 1
  }
}
configure() { # BULLET_ROOT [OPTION]; without tests, which take most of the time and find no Bullet of their own
  rm -rf "$work/build"
  cmake -S "$source" -B "$work/build" "-DCMAKE_CXX_COMPILER=$compiler" "-DBullet_ROOT=$1" -DDGD_BUILD_DEMOS=OFF \
    "${2--DDGD_BUILD_TESTS=OFF}"
}
prints "Found DgdBullet3: float in $work/float (" configure "$work/float"
prints "Found DgdBullet3: float64 in $work/float64 (" configure "$work/float64" -DDGD_BUILD_TESTS=ON
printed "The tests are left out"
prints "float in $work/float, float64 in $work/float64 (" configure "$work/float;$work/float64"
prints "Bullet_ROOT names the prefix" configure "$work/nowhere"

build_app() { # BULLET_ROOT PRECISION
  rm -rf "$work/app"
  cmake -S "$source/tests/package/consumer" -B "$work/app" "-DCMAKE_CXX_COMPILER=$compiler" "-DBullet_ROOT=$1" \
    "-DCMAKE_PREFIX_PATH=$installed" "-DPRECISION=$2" && cmake --build "$work/app" && "$work/app/falling_box"
}
prints "float64 in $work/float64 (" build_app "$work/float64" float64
printed "0 fallbacks, float64"
prints "0 fallbacks, float" build_app "$work/float" float
prints "There is Bullet" build_app "$work/float64" float
prints "and here is 9.99" build_app "$work/later" float64
