#!/usr/bin/env bash
# Remakes docs/paper.md with its tables and pictures: the figures of [Lin25] beside ours.
#   docs/paper/make.sh [RUNS]     RUNS: folder of the runs, kept and gone on with; runs/paper unless given. Hours on two cores.
#   docs/paper/make.sh RUNS page  only the page, from runs that are there
set -euo pipefail
cd "$(dirname "$0")/../.."
runs=${1:-runs/paper}
page=docs/paper.md pictures=docs/paper
sweeps=(validation_drop validation_sensitivity ground attitudes friction velocity explanations bed bed_grains)

if [[ ${2-} != page ]]; then
  ./footfall run --force --out "$runs/landing" --set output.vtk=true --set output.vtk_interval=0.05
  ./footfall pictures "$runs/landing" --times 0.05,0.25,0.5,1.0 --width 1000
  for sweep in "${sweeps[@]}"; do ./footfall sweep "inputs/sweeps/$sweep.toml" --out "$runs/$sweep" || echo "make.sh: sweep $sweep is not complete" >&2; done
else
  for sweep in "${sweeps[@]}"; do [[ ! -d $runs/$sweep/runs ]] || ./footfall sweep "inputs/sweeps/$sweep.toml" --out "$runs/$sweep" --merge >/dev/null || true; done
fi

picture() {  # FILE NAME TITLE: copies it, and shows it
  [[ -f $1 ]] || { echo "*$3: not run.*"; echo; return; }
  cp "$1" "$pictures/$2.png"
  printf '![%s](paper/%s.png)\n\n' "$3" "$2"
}
tables() {  # SWEEP: its cases and what should come out
  [[ -f $runs/$1/cases.md ]] || { echo "*Not run: \`./footfall sweep inputs/sweeps/$1.toml\`*"; echo; return; }
  cat "$runs/$1/cases.md"; echo
  [[ ! -f $runs/$1/statements.md ]] || { cat "$runs/$1/statements.md"; echo; }
}
studies() {  # SWEEP FIGURE PLOT...
  local sweep=$1 figure=$2 plot letter=a
  shift 2
  for plot in "$@"; do
    picture "$runs/$sweep/$plot.png" "figure${figure}${letter}" "Figure ${figure}${letter}"
    letter=$(tr 'a-y' 'b-z' <<< "$letter")
  done
  tables "$sweep"
}

{
  cat <<'TEXT'
# The paper's validation and studies, and what comes out here

Lin, H.; Lei, B.; Yao, W. A FMBD-DEM coupled modeling for semi-active controlled lunar lander. Aerospace 2025, 12, 935 [Lin25]. This page is made by
`docs/paper/make.sh`; every table names the command that makes it. The paper does not print the legs' geometry, the crush forces, the bed or its density, the
controller's rules and many more numbers; what is assumed instead is marked [A] in the scenes. Nothing was changed to meet a printed figure: what does not
come out is listed as such, with what a run says about why.

## Table 2: validation drop

Maximum force is read as per pad.

TEXT
  tables validation_drop
  picture "$runs/validation_drop/force.png" table2_force "Force on pad 1"
  picture "$runs/validation_drop/depth.png" table2_depth "Height of pad 1"
  cat docs/paper/reading_validation.md; echo
  tables validation_sensitivity
  printf '## Figure 10: grains by speed\n\nMade by `./footfall run --set output.vtk=true --set output.vtk_interval=0.05 --out DIR` and `./footfall pictures DIR`.\n\n'
  for file in "$runs"/landing/pictures/*.png; do [[ ! -f $file ]] || picture "$file" "figure10_$(basename "$file" .png)" "Grains and lander, $(basename "$file" .png)"; done
  printf '## Figure 11: the landing\n\nMade by `./footfall run`.\n\n'
  picture "$runs/landing/plots/overview.png" figure11 "Acceleration, velocity, descent, energy, strokes and forces"
  printf '## Energy ledger\n\nMade by `./footfall run`: where the energy of the lander went, and what the grains did with theirs.\n\n'
  picture "$runs/landing/plots/ledger.png" ledger "Energy ledger of lander and grains"
  printf '## Figure 12: discrete and rigid ground\n\n'
  studies ground 12 acceleration energy
  printf '## Figure 13: attitude\n\n'
  studies attitudes 13 acceleration velocity energy
  printf '## Figure 14: friction\n\n'
  studies friction 14 acceleration velocity energy
  printf '## Figure 15: velocity\n\n'
  studies velocity 15 acceleration energy
  printf '## Explanations\n\n'
  picture "$runs/explanations/acceleration.png" explanations "Cabin acceleration"
  tables explanations
  printf '## Does the bed decide?\n\n'
  tables bed
  tables bed_grains
  cat docs/paper/reading.md
} > "$page.new"
mv "$page.new" "$page"
echo "$page"
