#!/bin/sh
# Static checks: cppcheck, and clang-tidy with the list of .clang-tidy.
#
#   sh tests/static_checks.sh               of the two libraries; some minutes
#   sh tests/static_checks.sh --all         of programs and tests as well; over an hour
#   sh tests/static_checks.sh --quick       cppcheck alone, of all; ten seconds, as in continuous integration
#   sh tests/static_checks.sh FILE.cc...    of these
#
# Exit status: 0 nothing found; 1 something found; 2 wrong arguments.
set -eu
root=$(CDPATH='' cd "$(dirname "$0")/.." && pwd)
. "$root/demos/setup.sh"
cd "$root"

with_tidy=yes
case ${1-} in
  --all) set -- dgd_core bullet_plugin demos tests ;;
  --quick)
    with_tidy=
    set -- dgd_core bullet_plugin demos tests
    ;;
  -*)
    sed -n '2,/^set -eu/{/^#/s/^# \{0,1\}//p}' "$0" >&2
    exit 2
    ;;
  '') set -- dgd_core bullet_plugin ;;
esac
status=0

install_packages cppcheck
# Warnings and above; Eigen's and Bullet's headers are not looked at, so what they declare is unknown to it.
#  internalAstError, syntaxError  templated lambdas and requires-clauses, which cppcheck 2.10 does not parse yet
#  unknownMacro                   Qhull's loops
# In one configuration, that of users: each macro that is left open would double the time.
cppcheck --std=c++20 --language=c++ --quiet --error-exitcode=1 --enable=warning,performance,portability \
  --inline-suppr --suppress=missingInclude --suppress=missingIncludeSystem --suppress=internalAstError \
  --suppress=syntaxError --suppress=unknownMacro -DNDEBUG -UDGD_FLATTEN_QUERIES -j "$(nproc)" -I dgd_core/include \
  -I bullet_plugin/include -I bullet_plugin/record/include -I bullet_plugin/src -I demos -I tests "$@" || status=1
[ -n "$with_tidy" ] || exit "$status"

install_packages clang-tidy-14
[ -e "$build_dir/compile_commands.json" ] || configure -DDGD_BUILD_TESTS=ON
# The two flags are for g++'s options that clang does not have.
find "$@" -name '*.cc' ! -path '*/package/*' ! -name '*_avx2.cc' -print0 | sort -z |
  xargs -0 -P "$(nproc)" -n 1 clang-tidy-14 -p "$build_dir" --quiet \
    --extra-arg=-Wno-unknown-warning-option --extra-arg=-Wno-ignored-optimization-argument || status=1
exit "$status"
