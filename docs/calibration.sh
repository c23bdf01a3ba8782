#!/usr/bin/env bash
# Remakes the results of docs/calibration.md: the calibrations of inputs/calibrations, with their tables and pictures.
#   docs/calibration.sh [RUNS [PART...]]     RUNS: folder of the runs, kept and gone on with; runs/calibrations unless given. PART: these parts alone, of those listed
#                                            below; "page": no part, the page alone
# The tables of a part are kept in docs/calibration/made/PART.txt, and what its runs said in docs/calibration/PART_numbers.jsonl where they took hours.
set -euo pipefail
cd "$(dirname "$0")/.."
. docs/parts.sh
runs=${1:-runs/calibrations}
page=docs/calibration.md pictures=docs/calibration
footfall=${FOOTFALL:-./footfall}
all=(strut soil grains paper_plane paper)
shown=()   # the parts that have been made

# NAME: its runs' numbers, where they stand with the page.
take_numbers() {
  local kept=$pictures/$1_numbers.jsonl
  mkdir -p "$runs/$1"
  [[ -f $runs/$1/numbers.jsonl || ! -f $kept ]] || cp "$kept" "$runs/$1/numbers.jsonl"
}
# NAME: its page, with headings one level lower and pictures in a folder of their own.
calibration() {
  local name=$1 kept=$pictures/$1_numbers.jsonl picture
  take_numbers "$name"
  "$footfall" calibrate "inputs/calibrations/$name.toml" --out "$runs/$name" >&2
  [[ ! -f $kept ]] || cp "$runs/$name/numbers.jsonl" "$kept"
  sed -E "s/^#/##/; s/^!\[(.*)\]\((.*)\)/![\1](calibration\/${name}_\2)/" "$runs/$name/$name.md"
  for picture in misfit parameters targets; do [[ ! -f $runs/$name/$picture.png ]] || cp "$runs/$name/$picture.png" "$pictures/${name}_$picture.png"; done
}
part_strut() { calibration strut; }
part_soil() { calibration soil; }
part_grains() { calibration grains; }
part_paper_plane() { calibration paper_plane; }
part_paper() { calibration paper; }

make_parts docs/calibration "${@:2}"
for part in "${all[@]}"; do [[ ! -f $pictures/made/$part.txt ]] || shown+=("$pictures/made/$part.txt"); done
sed -i '/^<!-- made by docs\/calibration.sh -->$/,$d' "$page"
{
  echo '<!-- made by docs/calibration.sh -->'
  awk 'FNR == 1 && NR > 1 { print "" } { print }' "${shown[@]}"
} >>"$page"
