#!/usr/bin/env bash
# damaged_checkpoint.sh FOOTFALL OUT: a checkpoint whose files are cut, changed, empty or missing is told and the one before it is taken; when none is whole, and when
# a file of the run is shorter than the checkpoint knows it, that is exit code 2 with the file's name. Never a run that goes on from rubbish.
set -u
footfall=$1 out=$2 here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$out" && mkdir -p "$out" && cd "$out" || exit 1
die() { echo "damaged_checkpoint.sh: $*"; cat ./*.txt; exit 1; }
"$footfall" run "$here/../../inputs/accuracy/scenes/slider_crank.toml" --quiet --until 0.05 --set output.checkpoint_interval=0.015 --out good >good.txt 2>&1 ||
  die "the run failed"
mapfile -t sets < <(ls good/checkpoint | sort -n)
((${#sets[@]} == 2)) || die "expected two sets, found: ${sets[*]}"
older=${sets[0]} newer=${sets[1]} tried=0

# damage FILE HOW
damage() {
  case $2 in
    missing) rm "$1" ;;
    empty) : >"$1" ;;
    half) truncate -s "$(($(stat -c %s "$1") / 2))" "$1" ;;
    longer) printf 'x' >>"$1" ;;
    flipped) printf '\377' | dd of="$1" bs=1 seek="$(($(stat -c %s "$1") / 3))" conv=notrunc status=none ;;
  esac
}
resume() { code=0; timeout -k 2 60 "$footfall" run --resume bad --quiet >said.txt 2>&1 || code=$?; tried=$((tried + 1)); }
for how in missing empty half longer flipped; do
  for file in run.txt start.json checksums.txt; do
    rm -rf bad && cp -r good bad && damage "bad/checkpoint/$newer/$file" "$how"
    resume
    [[ $code == 0 ]] || die "$file $how: ended with $code, expected to go on from the older set"
    cmp -s good/history.csv bad/history.csv || die "$file $how: another history"
  done
  rm -rf bad && cp -r good bad
  damage "bad/checkpoint/$newer/run.txt" "$how" && damage "bad/checkpoint/$older/start.json" "$how"
  resume
  [[ $code == 2 ]] || die "no whole set, $how: ended with $code, expected 2"
  grep -q "$newer: run.txt is damaged" said.txt && grep -q "$older: start.json is damaged" said.txt || die "$how: not both sets are named"
done
for how in missing empty half; do
  rm -rf bad && cp -r good bad && damage bad/history.csv $how
  resume
  [[ $code == 2 ]] || die "history $how: ended with $code, expected 2"
  grep -q 'history.csv: has [0-9]* bytes, the checkpoint expects at least' said.txt || die "history $how: the message does not name it"
done
rm -rf bad && cp -r good bad && rm -r bad/checkpoint
resume
[[ $code == 2 ]] && grep -q 'has no checkpoint to go on from' said.txt || die "no checkpoint: ended with $code"
echo "$tried damaged checkpoints and histories tried"
exit 0
