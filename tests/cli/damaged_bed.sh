#!/usr/bin/env bash
# damaged_bed.sh FOOTFALL OUT SCENE: a kept bed that is damaged is told and made again; LIGGGHTS reads such a file for ever. SCENE:
# inputs/dropped_sphere, here on a bed of some hundred grains.
set -u
footfall=$1 out=$2 scene=$3
die() { echo "$*"; cat "$out/said.txt"; exit 1; }
rm -rf "$out" && mkdir -p "$out" && cd "$out" || exit 1
export FOOTFALL_CACHE=$out/cache
run() {
  timeout -k 2 60 "$footfall" run "$scene" --quiet --force --out run --until 0.002 --set output.plots=false --set particles.ranks=1 \
    --set bodies.ball.shape.radius=0.07 --set particles.variables.width=0.42 --set particles.bed.variables.width=0.42 \
    --set particles.bed.variables.depth=0.1 --set particles.bed.variables.settle=0.02 --set particles.bed.variables.rest=0.01 >said.txt 2>&1
}
run || die "the first run failed with code $?"
beds=(cache/beds/*/)
bed=${beds[0]}bed.restart
[[ -f $bed && -f ${beds[0]}bed.seal ]] || die "there is no sealed bed"
cp "$bed" whole && cp "${beds[0]}bed.seal" seal
run || die "the second run failed with code $?"
grep -q damaged said.txt && die "a whole bed counts as damaged"

damage() {
  case $1 in
    empty) : >"$bed" ;;
    half) head -c $(($(stat -c %s whole) / 2)) whole >"$bed" ;;
    flipped) printf '\377\377\377\377' | dd of="$bed" bs=1 seek=6000 conv=notrunc status=none ;;
    missing) rm "$bed" ;;
    half_without_seal) rm "${beds[0]}bed.seal"; head -c $(($(stat -c %s whole) / 2)) whole >"$bed" ;;
  esac
}
for how in empty half flipped missing half_without_seal; do
  damage $how
  run || die "$how: the run failed with code $?"
  grep -q 'warning: the bed in .* is damaged: .*; it is made again' said.txt || die "$how: nothing is said of it"
  cmp -s whole "$bed" || die "$how: the bed made again is another one"
done
cp seal "${beds[0]}bed.seal"
(($(ls -d cache/beds/*/ | wc -l) == 1)) || die "more than the bed is left: $(ls cache/beds)"

# A restart file that the script names itself.
head -c 1000 whole >cut.restart
sed -e 's|read_restart .*|read_restart cut.restart|' "$scene/in.grains" >own.in
timeout -k 2 60 "$footfall" run "$scene" --quiet --out own --set particles.script="\"$out/own.in\"" --set particles.variables.here="\"$scene\"" >said.txt 2>&1
code=$?
[[ $code == 2 ]] || die "a cut restart file of the script: exit code $code, expected 2"
grep -q 'own.in:[0-9]*: read_restart cut.restart: cut.restart does not' said.txt || die "the cut restart file is not named"
exit 0
