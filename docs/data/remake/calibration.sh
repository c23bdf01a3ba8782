#!/usr/bin/env bash
# Remakes docs/data/calibration: the calibrations of inputs/calibrations. What the runs of `paper` said is kept in paper_numbers.jsonl: with it that part takes minutes.
#   docs/data/remake/calibration.sh [RUNS [PART...]]     RUNS: folder of the runs (default runs/calibrations). PART: strut soil grains paper_plane paper paper_energy
set -euo pipefail
cd "$(dirname "$0")/../../.."
. docs/data/remake/parts.sh
runs=${1:-runs/calibrations}
data=docs/data/calibration
footfall=${FOOTFALL:-./footfall}
all=(strut soil grains paper_plane paper paper_energy)

# NAME: its page as text, without pictures.
calibration() {
  local name=$1 kept=$data/$1_numbers.jsonl
  mkdir -p "$runs/$name"
  [[ -f $runs/$name/numbers.jsonl || ! -f $kept ]] || cp "$kept" "$runs/$name/numbers.jsonl"
  "$footfall" calibrate "inputs/calibrations/$name.toml" --out "$runs/$name" >&2
  [[ ! -f $kept ]] || cp "$runs/$name/numbers.jsonl" "$kept"
  sed -E '/^!\[/d' "$runs/$name/$name.md"
}
for name in "${all[@]}"; do eval "part_$name() { calibration $name; }"; done

make_parts $data "${@:2}"
