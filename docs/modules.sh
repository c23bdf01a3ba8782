#!/usr/bin/env bash
# The modules and their dependencies, from the includes of the code: docs/modules.dot (text) and docs/modules.png.
#   docs/modules.sh           writes both (the picture needs Debian's graphviz)
#   docs/modules.sh --check   fails when docs/modules.dot differs from the code
set -euo pipefail
cd "$(dirname "$0")/.."

# The module of each path: mbd_solver/NAME, coupler/base, coupler, or the parts of liggghts_fix.
kModule='s,^(mbd_solver/[a-z_]+|coupler/base|liggghts_fix/[a-z_]+)/.*,\1,; s,^(mbd_solver|coupler|liggghts_fix)/.*\.(h|cpp)$,\1,; s,^coupler/schemes.*,coupler,'

arrows() {  # "from" -> "to" for every include that crosses two modules
  grep -rE '^#include "(coupler|liggghts_fix|mbd_solver)/[^"]*\.h"' coupler liggghts_fix mbd_solver --include=*.h --include=*.cpp |
    sed -E 's,:#include "([^"]*)".*, \1,' | while read -r from to; do printf '%s\n%s\n' "$from" "$to"; done |
    sed -E "$kModule; s,^(mbd_solver/[a-z_]+|coupler/base|liggghts_fix/[a-z_]+)\$,\1," | paste -d ' ' - - | sort -u |
    while read -r from to; do [[ $from == "$to" ]] || echo "  \"$from\" -> \"$to\";"; done
}

dot_text() {
  echo '// Made by docs/modules.sh from the includes of the code: an arrow points to a module that is used.'
  echo 'digraph footfall {'
  echo '  rankdir=LR; node [shape=box, style="rounded,filled", fillcolor="#f3f6fa", color="#4a6b8a", fontname="DejaVu Sans"]; edge [color="#7a8a99"];'
  arrows
  echo '}'
}

if [[ ${1-} == --check ]]; then
  diff <(dot_text) docs/modules.dot >/dev/null && exit 0
  echo "docs/modules.dot differs from the includes of the code:"
  diff docs/modules.dot <(dot_text) || true
  echo "If the new dependencies are intended, run docs/modules.sh and check docs/modules.png."
  exit 1
fi
dot_text >docs/modules.dot
command -v tred >/dev/null || { echo "docs/modules.dot is written; for the picture install graphviz (apt-get install graphviz)"; exit 0; }
tred docs/modules.dot | dot -Tpng -Gdpi=70 -o docs/modules.png   # without arrows that follow from others
