#!/bin/sh
# The page of demos/report.sh from a brief run: every figure is there, and in a browser nothing is missing or broken.
# Skipped (status 77) where there is no Chromium or no matplotlib. Needs the programs that report.sh builds.
set -eu
root=$(CDPATH='' cd "$(dirname "$0")/.." && pwd)
command -v chromium >/dev/null || exit 77
/usr/bin/python3 -c 'import matplotlib' 2>/dev/null || exit 77

folder=$(mktemp -d "${TMPDIR:-/tmp}/dgd-report.XXXXXX")
trap 'rm -rf "$folder"' EXIT
fail() {
  echo "error: $*" >&2
  exit 1
}

sh "$root/demos/report.sh" --brief --no-build --out "$folder"
for name in error times_cold times_warm vertices convergence replay drop; do
  grep -q "<figure id=\"$name\"><svg" "$folder/index.html" || fail "the page has no figure $name"
  [ -s "$folder/$name.svg" ] || fail "there is no $name.svg"
  grep -q "($name.svg)" "$folder/report.md" || fail "report.md does not show $name"
done
grep -q '<td>ellipsoids, margin 0 m</td>' "$folder/index.html" || fail "the page has no table of shapes"
grep -q 'src="http\|href="http' "$folder/index.html" && fail "the page needs the network"

# What a browser makes of it: how many figures have an extent, and how many pictures have pixels.
cp "$folder/index.html" "$folder/asked.html"
cat >>"$folder/asked.html" <<'SCRIPT'
<script>
addEventListener('load', () => {
  const seen = element => element.getBoundingClientRect().height > 100 && element.getBoundingClientRect().width > 100;
  const drawings = [...document.querySelectorAll('figure svg')], pictures = [...document.images];
  document.title = 'drawings ' + drawings.filter(seen).length + ' of ' + drawings.length + ', pictures ' +
                   pictures.filter(i => i.naturalWidth > 100 && seen(i)).length + ' of ' + pictures.length;
});
</script>
SCRIPT
chromium --headless --no-sandbox --disable-gpu --virtual-time-budget=10000 --dump-dom "file://$folder/asked.html" \
  2>/dev/null | grep -o '<title>[^<]*' >"$folder/title" || fail "the browser gives no page"
grep -q 'drawings 7 of 7, pictures 2 of 2' "$folder/title" || fail "the browser sees $(cat "$folder/title")"
