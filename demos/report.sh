#!/bin/sh
# Speed against error on one page: installs what is missing, builds, measures, and writes out/report/index.html, the
# same as report.md, and all figures as CSV and SVG. Some minutes of measuring; with --full about an hour; with --brief
# seconds, to see that all of it runs. --out DIR for another folder; --no-build measures with what is built.
set -eu
root=$(CDPATH='' cd "$(dirname "$0")/.." && pwd)
. "$root/demos/setup.sh"

out=$root/out/report extent=short must_build=yes
while [ $# -gt 0 ]; do
  case $1 in
    --full) extent=full ;;
    --brief) extent=brief ;;
    --no-build) must_build=no ;;
    --out)
      [ $# -gt 1 ] || fail "--out needs a folder"
      out=$2
      shift
      ;;
    --out=*) out=${1#--out=} ;;
    *) fail "no such option: $1 (there are --full, --brief, --no-build and --out DIR)" ;;
  esac
  shift
done
# Pairs of a class, of a vertex count, of the record and of shapes, poses of each, and seconds and seeds of the fall.
case $extent in
  full) pairs=1000 poses=100 count_pairs=100 replayed=100000 shape_pairs=2000 seconds=10 seeds=20 ;;
  short) pairs=60 poses=10 count_pairs=20 replayed=5000 shape_pairs=100 seconds=10 seeds=3 ;;
  brief) pairs=4 poses=2 count_pairs=2 replayed=50 shape_pairs=2 seconds=1.5 seeds=1 ;;
esac

if [ "$must_build" = yes ]; then
  # shellcheck disable=SC2086 # lists of words
  install_packages $build_packages $test_packages python3-matplotlib
  configure -DDGD_BUILD_TESTS=ON
  build polytope_drop polytope_drop_float64 solution_times narrowphase_replay narrowphase_replay_float64 shape_pairs \
    shape_pairs_float64
fi

bench=$build_dir/tests/bench data=$out/data
[ ! -e "$data/machine.txt" ] || echo "$out: had the results of another report; replaced" >&2
[ -z "$(find "$out/" -type l 2>/dev/null)" ] || fail "$out has links in it, and nothing is written through links"
mkdir -p "$data"
vertex_counts=vertices-8,vertices-32,vertices-128,vertices-512,vertices-2048,vertices-4096
"$bench/solution_times" --tolerances --pairs "$pairs" --poses "$poses" --csv "$data/solution_times.csv" \
  --classes curved,meshes,rounded-hulls,sharp-hulls,dsf,2d >"$data/solution_times.txt"
"$bench/solution_times" --pairs "$count_pairs" --poses "$poses" --csv "$data/vertex_count.csv" \
  --classes "$vertex_counts" >"$data/vertex_count.txt"
"$bench/solution_times" --convergence --pairs "$pairs" --poses "$poses" --classes curved,meshes >"$data/convergence.csv"
for precision in float float64; do
  suffix=
  [ "$precision" = float ] || suffix=_float64
  seed=1
  while [ "$seed" -le "$seeds" ]; do
    options=--no-snapshots
    [ "$seed" -gt 1 ] || options=--record # and pictures
    "$build_dir/demos/polytope_drop$suffix" --seed "$seed" --duration "$seconds" $options --overwrite \
      --out "$data/drop/$precision/seed_$seed" >"$data/drop_$precision.txt"
    seed=$((seed + 1))
  done
  # A wrong answer of ours is told by the page, and does not keep it from being made.
  "$bench/narrowphase_replay$suffix" "$data/drop/$precision/seed_1/builtin.rec" --pairs "$replayed" \
    --csv "$data/replay_$precision.csv" >"$data/replay_$precision.txt" || [ $? -eq 1 ]
  "$bench/shape_pairs$suffix" --pairs "$shape_pairs" --csv "$data/shape_pairs_$precision.csv" \
    >"$data/shape_pairs_$precision.txt" || [ $? -eq 1 ]
done
{
  sed -n 's/^model name[^:]*: */Processor: /p' /proc/cpuinfo | sort -u
  echo "Cores: $(nproc)"
  echo "Compiler: $(${CXX:-c++} --version | head -n 1); release build, x86-64 baseline, vertex scans with AVX2 where there is"
  echo "Commit: $(git -C "$root" log -1 --format='%h, %cs' 2>/dev/null || echo unknown)"
  echo "Extent: $extent; $pairs pairs x $poses poses a class, $seeds falls, $replayed recorded pairs," \
    "$shape_pairs pairs of shapes a class; seed 1"
} >"$data/machine.txt"
/usr/bin/python3 "$root/demos/report/page.py" "$out"
