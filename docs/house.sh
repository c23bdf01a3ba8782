#!/usr/bin/env bash
# The house on one page, drawn from the includes of the code: docs/house.dot (text), docs/house.png.
#   docs/house.sh           writes both (the picture needs Debian's graphviz)
#   docs/house.sh --check   fails when docs/house.dot is not what the code says now
set -euo pipefail
cd "$(dirname "$0")/.."

rooms=(coupler/base coupler liggghts_fix
  mbd_solver/{fe,model,model/laws,model/elements,model/controllers,model/signals,dynamics,integrator}
  mbd_solver/{scene,build,coupling,output,observe,run} mbd_solver/cli/{grains,launch,analysis,experiments,calibrate,rigs})

# "from" -> "to" for every include that crosses two rooms; model/joints belongs to model, coupler/schemes to coupler, cli/analysis/viewer to
# cli/analysis.
arrows() {
  local room
  for room in "${rooms[@]}"; do
    [[ -d $room ]] || continue
    find "$room" $([[ $room == coupler ]] && echo coupler/schemes) $([[ $room == */analysis ]] && echo "$room/viewer") -maxdepth 1 -name '*.h' -o -maxdepth 1 -name '*.cpp' | sort | xargs grep -hoE '^#include "(coupler|liggghts_fix|mbd_solver)/[^"]*"' |
      sed -E 's/#include "(.*)\/[^/]*"/\1/; s,model/joints,model,; s,coupler/schemes,coupler,; s,analysis/viewer,analysis,' | sort -u | while read -r to; do
        [[ $to == "$room" ]] || echo "  \"$room\" -> \"$to\";"
      done
  done
}

dot_text() {
  echo '// Made by docs/house.sh from the includes of the code: an arrow points to what a room uses.'
  echo 'digraph footfall {'
  echo '  rankdir=LR; node [shape=box, style="rounded,filled", fillcolor="#f3f6fa", color="#4a6b8a", fontname="DejaVu Sans"]; edge [color="#7a8a99"];'
  arrows
  echo '}'
}

if [[ ${1-} == --check ]]; then
  diff <(dot_text) docs/house.dot >/dev/null && exit 0
  echo "docs/house.dot is not what the code says now:"
  diff docs/house.dot <(dot_text) || true
  echo "If the new arrows are meant, run docs/house.sh and look at docs/house.png."
  exit 1
fi
dot_text >docs/house.dot
command -v tred >/dev/null || { echo "docs/house.dot is written; for the picture install graphviz (apt-get install graphviz)"; exit 0; }
tred docs/house.dot | dot -Tpng -Gdpi=80 -o docs/house.png   # arrows that follow from others are left out
