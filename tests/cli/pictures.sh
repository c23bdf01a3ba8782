#!/usr/bin/env bash
# pictures.sh FOOTFALL OUT: pictures of a run that dumped its grains, with its bodies as drawn and as recorded; bad input is told and writes nothing.
set -euo pipefail
footfall=$1 out=$2 here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$out"
run() { "$footfall" run "$here/../bad_input/plate_on_grains.scene" --set particles.script="\"$here/replay/in.plate\"" --out "$@" --quiet; }
run "$out/drawn"
run "$out/recorded" --set output.vtk=false
for how in drawn recorded; do
  "$footfall" pictures "$out/$how" --times 0,0.021 --fastest 100 > "$out/$how.said" 2> "$out/$how.warned"
  "$footfall" pictures "$out/$how" --times 0.02 --cut --view=-80,10 --fastest 100 --width 1000 > /dev/null 2>&1
  # 0.02 s is the dump nearest to 0.021 s.
  for name in grains_0.0000s grains_0.0200s cut_0.0200s; do
    [[ $(head -c 4 "$out/$how/pictures/$name.png" | tail -c 3) == PNG ]]
    # The plate, grey, and the grains, sand (all slow beside 100 m/s), are in it.
    od -An -v -tu1 -w3 "$out/$how/pictures/$name.rgb" | awk -v name="$how/$name" '$1 > 100 && $3 > $1 { grey++ } $1 > $3 + 15 { sand++ }
      END { if (grey < 1000 || sand < 1000) { print name ": " grey + 0 " grey and " sand + 0 " sandy pixels"; exit 1 } }'
  done
  grep -q "grains_0.0200s.png" "$out/$how.said"
done
[[ ! -s $out/drawn.warned ]]
grep -q "output.vtk=true" "$out/recorded.warned"

# refused EXPECTED ARGUMENTS...
refused() {
  local expected=$1; shift
  if "$footfall" pictures "$@" > "$out/refused" 2>&1; then echo "not refused: $*"; exit 1; else [[ $? == 2 ]]; fi
  grep -q -e "$expected" "$out/refused" || { cat "$out/refused"; exit 1; }
}
mkdir "$out/blind"; cp "$out/drawn/summary.json" "$out/blind"
refused "holds no summary.json" "$out"
refused "holds no dumps of grains" "$out/blind"
refused "expected times of the run, from 0 to 0.05" "$out/drawn" --times=-1
refused "no grain lies behind y" "$out/drawn" --cut-at 5
[[ ! -e $out/blind/pictures ]]
