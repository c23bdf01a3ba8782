#!/usr/bin/env bash
# What `surface smooth` costs beside `surface facets` on a scene whose boundaries are curved: instructions of LIGGGHTS on one rank, counted by valgrind (callgrind), so
# that nothing else on the machine matters.
#   tests/bench/smooth_cost.sh BUILD [SCENE [SECONDS]]    a scene with [particles.box]; default: examples/02_wheel, 0.06 s of simulated time
set -eu
(( $# )) || { sed -n '2,4p' "$0"; exit 2; }
build=$(realpath "$1") scene=${2:-examples/02_wheel} seconds=${3:-0.06}
cd "$(dirname "$0")/../.."
command -v valgrind >/dev/null || { echo "smooth_cost.sh: valgrind is missing (a Debian package of that name)"; exit 2; }
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
counts=()
for surface in facets smooth; do
  # The run's own line, with windows of one length and with valgrind before the grains.
  line=$("$build/bin/footfall" run "$scene" --ranks 1 --until "$seconds" --set particles.variables.every=10 --out "$work/$surface" | grep -m 1 mpirun)
  grep -q "couples '" <<<"$line" || { echo "smooth_cost.sh: $scene has no [particles.box]"; exit 2; }
  line=${line/couples \'/couples \'surface $surface }
  line=${line/ $build\/bin\/liggghts_mbd/ valgrind --tool=callgrind --callgrind-out-file=$work/$surface.out $build\/bin\/liggghts_mbd}
  rm -rf "${work:?}/$surface"
  (eval "$line") >"$work/$surface.said" 2>&1 || { tail -n 20 "$work/$surface.said"; exit 1; }
  counts[${#counts[@]}]=$(sed -n 's/^summary: //p' "$work/$surface.out")
done
awk -v f="${counts[0]}" -v s="${counts[1]}" -v scene="$scene" -v t="$seconds" \
  'BEGIN { printf "%s, %g s: facets %.6g, smooth %.6g instructions of LIGGGHTS: %+.2f %%\n", scene, t, f, s, 100 * (s / f - 1) }'
