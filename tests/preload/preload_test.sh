#!/bin/sh
# Runs an app of one precision that is built without dgd_bullet by dgd-bullet-run, linked against Bullet and loading it
# by a plugin, and compares it with the plain app.
# Usage: preload_test.sh DGD_BULLET_RUN LINKED_APP LOADING_APP PLUGIN STATIC_APP FOREIGN_APP DGD_APP OUTPUT_DIR
set -eu
run=$1 linked=$2 loading=$3 plugin=$4 static=$5 foreign=$6 dgd=$7 output=$8
mkdir -p "$output"
cd "$output"

complain() { # MESSAGE FILE...
  echo "$1"
  shift
  cat "$@"
  exit 1
}
expect() { # PATTERN FILE
  grep -qE "$1" "$2" || complain "no '$1' in $2:" "$2"
}
expect_empty() {
  [ ! -s "$1" ] || complain "$1 is not empty:" "$1"
}
fails_with() { # STATUS TEXT COMMAND...: prints the text and nothing of the app's
  wanted=$1 text=$2
  shift 2
  status=0
  "$@" >out 2>err || status=$?
  if [ "$status" -ne "$wanted" ] || [ -s out ] || ! grep -qF -- "$text" err; then
    complain "$* did not fail with $wanted and '$text', but with $status:" out err
  fi
}
solved='"type_0": "BOX", "type_1": "BOX", "calls": [1-9][0-9]*,.*"solved": [1-9]'

# Apps that are linked and apps that load Bullet, with one world, several at once, and one after the other; and a heap.
for arrangement in one together sequence heap; do
  for kind in linked loading; do
    case $kind in
      linked) set -- "$linked" "$arrangement" ;;
      loading) set -- "$loading" "$plugin" "$arrangement" ;;
    esac
    "$@" >plain
    "$run" --statistics "$@" >ours 2>statistics || complain "$* fails on ours:" ours statistics
    expect "$solved" statistics
    expect '"type_0": "BOX", "type_1": "CONVEX_HULL", "calls": [1-9]' statistics
    expect '"fallbacks_not_converged": 0, ' statistics
    if cmp -s plain ours; then
      complain "$* ends with the built-in's poses" statistics
    fi

    # Switched off, it is the app itself to the last bit; without statistics it prints nothing.
    DGD_BULLET_OFF=1 "$run" --statistics "$@" >off 2>err
    cmp plain off
    expect_empty err
    "$run" "$@" >quiet 2>err
    cmp ours quiet
    expect_empty err

    # So it is under audit, with all that callbacks and queries see.
    "$run" --audit "$@" >audited 2>audit
    cmp plain audited
    expect 'BOX and BOX, [1-9][0-9]* calls' audit
    expect 'in both: [0-9.]+ %, which differ by up to' audit
  done
done

# Where spheres touch, all agree but for roundoff (the last audit is that of the heap).
for types in 'SPHERE and STATIC_PLANE' 'CONVEX_HULL and SPHERE' 'SPHERE and CAPSULE'; do
  grep -A 2 "^$types" audit >lines
  expect 'differ by up to 0|e-(0[6-9]|1[0-9]) \(half' lines
  expect 'worst, ours less the built-in.s, [-+][0-9.]+e-(0[6-9]|1[0-9])$' lines
  [ "$(grep -c 'only: ' lines)" -eq 0 ] || complain "$types: contacts in one only" audit
done

# Every world is the first one to the last bit, also on a narrowphase that another one has left.
[ "$("$run" "$linked" sequence | sort -u | wc -l)" -eq 4 ] || complain "worlds in sequence differ"
[ "$("$run" "$linked" together | sort -u | wc -l)" -eq 4 ] || complain "worlds side by side differ"

# Options reach the narrowphase: with single points no patch has four.
"$run" --set contact_patch=off --set patch_size=1 --statistics "$linked" one >out 2>statistics ||
  complain "one point a step fails:" out statistics
expect '"patch_sizes": \[[0-9]+, [1-9][0-9]*, 0, 0, 0\]' statistics
DGD_BULLET_OPTIONS=contact_patch=on,geometry_mode=sharp "$run" --set warm_start=off "$linked" one >out

# Errors are reported before the app starts.
# A copy of the script alone, and one in a folder that LD_PRELOAD would split.
mkdir -p alone 'with space'
cp "$run" alone/
fails_with 2 "libdgd_bullet_preload.so is neither in" alone/dgd-bullet-run "$linked" one
cp "$run" 'with space/'
: >'with space/libdgd_bullet_preload.so'
fails_with 2 "no path with a space or a colon" 'with space/dgd-bullet-run' "$linked" one
fails_with 2 "there is no option 'frction_anchors'" "$run" --set frction_anchors=off "$linked" one
fails_with 2 "option friction_anchors must be on or off, not 'perhaps'" "$run" --set friction_anchors=perhaps "$linked"
fails_with 2 "option max_iterations must be an integer, not '1e3'" "$run" --set max_iterations=1e3 "$linked" one
fails_with 2 "relative_tolerance must be in (0, 1)" "$run" --set=relative_tolerance=2 "$linked" one
fails_with 2 "there is no option --frob" "$run" --frob "$linked" one
fails_with 2 "which program?" "$run"
fails_with 127 "no_such_app is not found" "$run" ./no_such_app
: >not_executable
fails_with 126 "not_executable is not executable" "$run" ./not_executable
fails_with 126 "alone is a folder" "$run" ./alone
"$run" echo found >out
expect '^found$' out
fails_with 2 "static_app cannot be reached: Bullet is linked into it statically" "$run" "$static"
"$run" --help >out 2>err
expect 'libBulletCollision.so' out

# Without the script, the app itself goes on with the built-in.
library=$(dirname "$run")/libdgd_bullet_preload.so
"$linked" one >plain
LD_PRELOAD="$library" DGD_BULLET_OPTIONS=frction_anchors=off "$linked" one >out 2>err
cmp plain out
expect "there is no option 'frction_anchors'.*Bullet's own narrowphase is used" err
cp "$library" lonely.so
LD_PRELOAD="$PWD/lonely.so" "$linked" one >out 2>err
cmp plain out
expect "cannot open shared object file.*Bullet's own narrowphase is used" err
[ "$(wc -l <err)" -eq 1 ] || complain "more than a line:" err

# A Bullet that is not ours is left alone.
"$run" --statistics "$foreign" 2>err || complain "$foreign has changed" err
expect "libpreload_own_bullet.so is not the Bullet library that dgd_bullet is compiled for; Bullet's own" err
[ "$(wc -l <err)" -eq 1 ] || complain "more than a line:" err

# A program that uses dgd_bullet itself has contacts that are not the built-in's, and no report says that they are.
for report in audit statistics; do
  "$run" --$report "$dgd" 2>err || complain "$dgd has changed" err
  expect 'no pair went through dgd-bullet-run: none met, or the program uses dgd_bullet itself' err
done

# A process without Bullet reports that, and is otherwise left alone; its exit status is the app's.
"$run" --statistics "$loading" >out 2>err || [ $? -eq 2 ] || complain "another exit status" err
expect 'no Bullet was reached in this process' err
