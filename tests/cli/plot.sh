#!/usr/bin/env bash
# plot.sh FOOTFALL OUT: columns as pictures, by name, pattern and kind; what means no column is refused; a title stays a text.
set -euo pipefail
footfall=$1 out=$2 here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$out" && mkdir -p "$out"
die() { echo "plot.sh: $*"; exit 1; }
"$footfall" run "$here/../../inputs/rigid_plane" --until 0.03 --set output.plots=false --set output.vtk=false --quiet --out "$out/run"
plot() { "$footfall" plot "$out/run" "$@"; }
plot | grep -x 'cabin.az \[m/s2\]' > /dev/null || die "the columns are not listed"
plot cabin.az | grep 'plots/cabin.az.png' > /dev/null || die "the picture is not told"
plot 'struts.*.force' > /dev/null
gp=$out/run/plots/struts.all.force.gp
# Four legs of three struts: four panels with one scale, three curves each.
[[ $(grep -c '^set title' "$gp") == 8 && $(grep -c 'with lines' "$gp") == 24 ]] || die "struts are not drawn leg by leg"
[[ $(grep '^set yrange \[[-0-9]' "$gp" | sort -u | wc -l) == 1 ]] || die "the legs have scales of their own"
grep -q 'force \[k\?N\]' "$gp" || die "the axis has no unit"
for ending in png svg; do
  plot cabin.v cabin.az --title 'a "b" `touch stray` $(touch stray)' --out "$out/both.$ending" > /dev/null
  [[ -s $out/both.$ending ]] || die "no both.$ending"
done
[[ ! -e stray && ! -e $out/run/plots/stray ]] || die "a title was run"
[[ $(head -c 4 "$out/both.png" | tail -c 3) == PNG ]] && grep -q '<svg' "$out/both.svg" || die "the endings do not say what the files are"
# refused EXPECTED ARGUMENTS...
refused() {
  local expected=$1 code=0; shift
  "$footfall" plot "$@" > "$out/refused" 2>&1 || code=$?
  [[ $code == 2 ]] && grep -q -e "$expected" "$out/refused" || { cat "$out/refused"; die "not refused: $*"; }
}
refused 'Did you mean "cabin.a' "$out/run" cabin.aw
refused 'expected the folder of a run' "$out"
refused 'expected .png or .svg' "$out/run" cabin.az --out x.pdf
# What was drawn belongs to the run: it goes with it.
grep -qx 'plots/struts.all.force.png' "$out/run/.footfall.files" || die "the picture is nobody's"
