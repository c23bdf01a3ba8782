#!/usr/bin/env bash
# shared_bed.sh FOOTFALL SCENE: two runs that need the same bed at once: one makes it, the other waits, says so, and uses it.
#   SCENE: inputs/dropped_sphere
set -u
footfall=$1 scene=$2
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
export FOOTFALL_CACHE=$work/cache
die() { echo "shared_bed.sh: $*"; cat "$work"/*.txt; exit 1; }
run() {
  "$footfall" run "$scene" --ranks 1 --until 0.001 --out "$work/$1" --set output.plots=false --set bodies.ball.shape.radius=0.07 \
    --set particles.variables.width=0.42 --set particles.bed.variables.width=0.42 --set particles.bed.variables.depth=0.1 \
    --set particles.bed.variables.settle=0.1 --set particles.bed.variables.rest=0.01 >"$work/$1.txt" 2>&1
}
run a & a=$!
until ls "$work"/cache/beds/*.part* >/dev/null 2>&1; do kill -0 $a 2>/dev/null || die "the first run ended"; sleep 0.02; done
run b || die "the second run failed"
wait $a || die "the first run failed"
grep -q "Making the bed" "$work/a.txt" || die "the first run made no bed"
! grep -q "Making the bed" "$work/b.txt" || die "the bed was made twice"
grep -q "another run makes this bed" "$work/b.txt" || die "the second run did not say that it waits"
[[ -s $work/a/summary.json && -s $work/b/summary.json ]] || die "there are no results"
exit 0
