#!/bin/sh
# A shared library exports what its public headers mark: of our names, Eigen's and Bullet's no less and no more. (What
# the standard library has in its headers is public in all libraries.)
# Usage: exports.sh LIBRARY HEADER_DIR, where the headers mark by DGD_EXPORT or DGD_BULLET_EXPORT
set -eu
library=$1 headers=$2
marked=$(grep -rhE 'DGD_(BULLET_)?EXPORT ' "$headers" |
  sed -nE 's/^class DGD_[A-Z_]*EXPORT ([A-Za-z]+).*/\1/p; s/^DGD_[A-Z_]*EXPORT [^(]*[ *&]([A-Za-z]+)\(.*/\1/p' | sort -u)
# Of our names the first one behind the namespaces, which are in small letters; others whole.
exported=$(nm -D --defined-only "$library" | sed 's/.* //' | c++filt -p | grep -E '\<(dgd(_bullet)?::|Eigen::|bt[A-Z])' |
  sed -E 's/^(typeinfo|typeinfo name|vtable) for //; s/^dgd(_bullet)?::([a-z0-9_]+::)?([A-Za-z]+).*/\3/' | sort -u)
[ "$marked" = "$exported" ] || {
  printf '%s\n' "$library exports:" "$exported" "and the headers mark:" "$marked"
  exit 1
}
