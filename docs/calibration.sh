#!/usr/bin/env bash
# Remakes the results of docs/calibration.md: the calibrations of inputs/calibrations, with their tables and pictures.
#   docs/calibration.sh [RUNS]     RUNS: folder of the runs, kept and gone on with; runs/calibrations unless given
set -euo pipefail
cd "$(dirname "$0")/.."
runs=${1:-runs/calibrations}
page=docs/calibration.md pictures=docs/calibration
mkdir -p "$pictures"
footfall=${FOOTFALL:-./footfall}
for name in strut grains paper_plane; do "$footfall" calibrate "inputs/calibrations/$name.toml" --out "$runs/$name" >/dev/null; done

sed -i '/^<!-- made by docs\/calibration.sh -->$/,$d' "$page"
{
  echo '<!-- made by docs/calibration.sh -->'
  for name in strut grains paper_plane; do
    # Its headings stand one level lower, its pictures in a folder of their own.
    sed -E "s/^#/##/; s/^!\[(.*)\]\((.*)\)/![\1](calibration\/${name}_\2)/" "$runs/$name/$name.md" | { [[ $name == strut ]] || echo; cat; }
    for picture in misfit parameters targets; do [[ ! -f $runs/$name/$picture.png ]] || cp "$runs/$name/$picture.png" "$pictures/${name}_$picture.png"; done
  done
} >>"$page"
