#!/bin/sh
# What a static library of the plugin defines is in its precision's namespace, except what is compiled once for both
# precisions: both libraries then have their own of all that knows Bullet.
# Usage: namespaces.sh LIBRARY float32|float64 OBJECT_COMPILED_ONCE...
set -eu
library=$1 namespace=$2
shift 2
outside() { # FILE...: functions and variables that are in no precision's namespace
  nm --defined-only "$@" | sed -nE 's/^[0-9a-f]+ [TDBR] //p' | c++filt -p | grep '^dgd_bullet::' |
    grep -v "^dgd_bullet::$namespace::" | sort -u
}
[ "$(outside "$library")" = "$(outside "$@")" ] || {
  printf '%s\n' "$library has outside of dgd_bullet::$namespace:" "$(outside "$library")" \
    "of which are compiled once:" "$(outside "$@")"
  exit 1
}
