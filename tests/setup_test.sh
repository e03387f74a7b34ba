#!/bin/sh
# What the two commands do on a machine where they cannot install what is missing: one line on the error stream that names
# the reason, a non-zero exit, and nothing built. And where nothing is missing, they do not call apt-get at all. The
# machine is a PATH with stand-ins for the package tools.
set -eu
root=$(CDPATH='' cd "$(dirname "$0")/.." && pwd)
work=$(mktemp -d "${TMPDIR:-/tmp}/dgd-setup-test.XXXXXX")
trap 'rm -rf "$work"' EXIT
failures=0

# A bare machine: the shell's own tools; dpkg-query knows of no package.
machine=$work/bin
new_machine() {
  rm -rf "$machine"
  mkdir "$machine"
  for tool in sh env dirname mktemp grep rm nproc; do
    ln -s "$(command -v "$tool")" "$machine/$tool"
  done
  stand_in dpkg-query 'exit 1'
}
# shellcheck disable=SC2016 # bodies are for the stand-in to expand
stand_in() { # NAME BODY
  printf '#!/bin/sh\n%s\n' "$2" >"$machine/$1"
  chmod +x "$machine/$1"
}

complain() {
  failures=$((failures + 1))
  echo "$*"
}

run_script() { # SCRIPT; sets `status`, leaves $work/out and $work/err
  status=0
  (cd / && TMPDIR=$work PATH=$machine "$(command -v sh)" "$root/$1" >"$work/out" 2>"$work/err") || status=$?
}

expect_one_line() { # CASE PATTERN
  for script in demos/run.sh tests/run.sh; do
    run_script "$script"
    if [ "$status" -eq 0 ] || [ "$(wc -l <"$work/err")" -ne 1 ] || ! grep -q "$2" "$work/err"; then
      complain "$script, $1: exit status $status, expected one line with '$2', got:"
      cat "$work/err"
    fi
  done
}

new_machine
stand_in id 'echo 0'
expect_one_line "no package manager" 'no apt-get'

rm "$machine/dpkg-query"
expect_one_line "not Debian at all" 'no apt-get'

new_machine
stand_in id 'echo 1000'
stand_in apt-get "touch '$work/called'"
expect_one_line "neither root nor sudo" 'root or sudo'

stand_in sudo 'echo "sorry" >&2; exit 1'
expect_one_line "sudo refuses" 'root or sudo'
[ ! -e "$work/called" ] || complain "apt-get was called without root"

new_machine
stand_in id 'echo 0'
stand_in apt-get 'case "$*" in *update*) exit 0 ;; esac; echo "E: Unable to fetch some archives" >&2; exit 100'
expect_one_line "no network" 'network'

new_machine
stand_in dpkg-query 'echo installed'
stand_in apt-get "touch '$work/called'"
stand_in cmake 'exit 42'
for script in demos/run.sh tests/run.sh; do
  run_script "$script"
  [ "$status" -eq 42 ] || complain "$script: exit status $status where cmake's 42 was expected"
  [ ! -e "$work/called" ] || complain "$script called apt-get though nothing is missing"
done

[ "$failures" -eq 0 ] || exit 1
echo "all as expected"
