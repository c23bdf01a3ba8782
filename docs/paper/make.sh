#!/usr/bin/env bash
# Remakes docs/paper.md with its tables and pictures: the figures of [Lin25] beside ours.
#   docs/paper/make.sh [RUNS]     RUNS: folder of the runs, kept and gone on with; runs/paper unless given. Hours on two cores.
#   docs/paper/make.sh RUNS identified  the identified column alone
#   docs/paper/make.sh RUNS page  only the page, from runs that are there
# Tables are kept in docs/paper/made, pictures beside it: what is not run again stands in the page as it was.
set -euo pipefail
cd "$(dirname "$0")/../.."
runs=${1:-runs/paper}
page=docs/paper.md pictures=docs/paper made=docs/paper/made
sweeps=(validation_drop validation_sensitivity ground attitudes friction velocity explanations bed bed_grains)
identified=(validation_drop ground attitudes friction velocity)   # run once more with the scenes of inputs/paper_identified

# SWEEP: the same one with the identified scenes; prints its file.
identified_sweep() {
  local file=$runs/identified/$1.toml scenes=$PWD/inputs/paper_identified
  mkdir -p "$runs/identified"
  sed -e "s#\"\.\./landing_mr/scene.toml\"#\"$scenes/scene.toml\"#; s#\"\.\./validation_drop/scene.toml\"#\"$scenes/validation_drop.toml\"#" \
    -e "s#\"\.\./validation_drop/rigid.toml\"#\"$scenes/validation_drop_rigid.toml\"#" \
    -e "s#^settings = \[\"initial.pitch_deg=4\"\]#scene = \"$scenes/two_two.toml\"#" \
    -e "s#^settings = \[\"initial.roll_deg=4\", \"initial.pitch_deg=4\"\]#scene = \"$scenes/one_two_one.toml\"#" "inputs/sweeps/$1.toml" >"$file"
  echo "$file"
}

if [[ -z ${2-} ]]; then
  ./footfall run --force --out "$runs/landing" --set output.vtk=true --set output.vtk_interval=0.05
  ./footfall pictures "$runs/landing" --times 0.05,0.25,0.5,1.0 --width 1000
  for sweep in "${sweeps[@]}"; do ./footfall sweep "inputs/sweeps/$sweep.toml" --out "$runs/$sweep" || echo "make.sh: sweep $sweep is not complete" >&2; done
fi
if [[ ${2-} != page ]]; then
  ./footfall run inputs/paper_identified --force --out "$runs/identified/landing" --set output.vtk=true --set output.vtk_interval=0.05
  ./footfall pictures "$runs/identified/landing" --times 0.05,0.25,0.5,1.0 --width 1000
  for sweep in "${identified[@]}"; do ./footfall sweep "$(identified_sweep "$sweep")" --out "$runs/identified/$sweep" || echo "make.sh: identified sweep $sweep is not complete" >&2; done
else
  for sweep in "${sweeps[@]}"; do [[ ! -d $runs/$sweep/runs ]] || ./footfall sweep "inputs/sweeps/$sweep.toml" --out "$runs/$sweep" --merge >/dev/null || true; done
  for sweep in "${identified[@]}"; do [[ ! -d $runs/identified/$sweep/runs ]] || ./footfall sweep "$(identified_sweep "$sweep")" --out "$runs/identified/$sweep" --merge >/dev/null || true; done
fi

# FROM TO: a table or a picture, kept beside the page when the runs have made it.
keep() { [[ ! -f $1 ]] || { mkdir -p "$(dirname "$2")" && cp "$1" "$2"; }; }
# FILE NAME TITLE: a picture, and beside it that of the identified runs.
pair() {
  keep "$runs/$1" "$pictures/$2.png"
  keep "$runs/identified/$1" "$pictures/$2_identified.png"
  [[ -f $pictures/$2.png ]] || { echo "*$3: not run.*"; echo; return; }
  if [[ -f $pictures/$2_identified.png ]]; then
    printf '| %s, as assumed | %s, identified |\n|---|---|\n| ![%s, as assumed](paper/%s.png) | ![%s, identified](paper/%s_identified.png) |\n\n' "$3" "$3" "$3" "$2" "$3" "$2"
  else
    printf '![%s](paper/%s.png)\n\n' "$3" "$2"
  fi
}
# SWEEP: what should come out, as assumed and identified.
statements() {
  local own=$made/$1.statements.md other=$made/identified/$1.statements.md
  [[ -f $own ]] || return 0
  if [[ -f $other ]]; then
    paste -d '\n' "$own" "$other" | awk -F ' [|] ' '
      NR % 2 == 1 { line = $0; for (k = 1; k <= NF; ++k) mine[k] = $k; next }
      /^[|]-/ { print "|---|---|---|---|---|---|"; next }
      NF < 4 { print line; next }
      { sub(/ [|]$/, "", mine[4]); theirs = $4; sub(/ [|]$/, "", theirs); sub(/:.*/, "", theirs) }
      NR == 2 { print mine[1] " | " mine[3] " | as assumed: " mine[2] " | " mine[4] " | identified: " $2 " | " theirs " |"; next }
      { print mine[1] " | " mine[3] " | " mine[2] " | " mine[4] " | " $2 " | " theirs " |" }'
  else
    cat "$own"
  fi
  echo
}
tables() {  # SWEEP: its cases and what should come out
  local table
  for table in cases statements; do
    keep "$runs/$1/$table.md" "$made/$1.$table.md"
    keep "$runs/identified/$1/$table.md" "$made/identified/$1.$table.md"
  done
  [[ -f $made/$1.cases.md ]] || { echo "*Not run: \`./footfall sweep inputs/sweeps/$1.toml\`*"; echo; return; }
  cat "$made/$1.cases.md"; echo
  if [[ -f $made/identified/$1.cases.md ]]; then
    printf 'Identified, the same with the scenes of `inputs/paper_identified`:\n\n'
    sed '/^Made by/,/^$/d' "$made/identified/$1.cases.md"; echo
  fi
  statements "$1"
}
studies() {  # SWEEP FIGURE PLOT...
  local sweep=$1 figure=$2 plot letter=a
  shift 2
  for plot in "$@"; do
    pair "$sweep/$plot.png" "figure${figure}${letter}" "Figure ${figure}${letter}"
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

Columns and pictures called "identified" are another lander and another bed: their unprinted numbers were sought so that as many as possible of the statements below come out together, and are not printed in the paper
([calibration](calibration.md#the-papers-unprinted-numbers), `inputs/paper_identified`). No other column, here or elsewhere, uses them.

## Table 2: validation drop

Maximum force is read as per pad.

TEXT
  tables validation_drop
  pair validation_drop/force.png table2_force "Force on pad 1"
  pair validation_drop/depth.png table2_depth "Height of pad 1"
  cat docs/paper/reading_validation.md; echo
  tables validation_sensitivity
  printf '## Figure 10: grains by speed\n\nMade by `./footfall run --set output.vtk=true --set output.vtk_interval=0.05 --out DIR` and `./footfall pictures DIR`.\n\n'
  for time in 0.0500 0.2500 0.5000 1.0000; do pair "landing/pictures/grains_${time}s.png" "figure10_grains_${time}s" "Grains and lander, $time s"; done
  printf '## Figure 11: the landing\n\nMade by `./footfall run`.\n\n'
  pair landing/plots/overview.png figure11 "Acceleration, velocity, descent, energy, strokes and forces"
  printf '## Energy ledger\n\nMade by `./footfall run`: where the energy of the lander went, and what the grains did with theirs.\n\n'
  pair landing/plots/ledger.png ledger "Energy ledger of lander and grains"
  printf '## Figure 12: discrete and rigid ground\n\n'
  studies ground 12 acceleration energy
  printf '## Figure 13: attitude\n\n'
  studies attitudes 13 acceleration velocity energy
  printf '## Figure 14: friction\n\n'
  studies friction 14 acceleration velocity energy
  printf '## Figure 15: velocity\n\n'
  studies velocity 15 acceleration energy
  printf '## Explanations\n\n'
  pair explanations/acceleration.png explanations "Cabin acceleration"
  tables explanations
  printf '## Does the bed decide?\n\n'
  tables bed
  tables bed_grains
  cat docs/paper/reading.md
} > "$page.new"
mv "$page.new" "$page"
echo "$page"
