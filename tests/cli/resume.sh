#!/usr/bin/env bash
# resume.sh FOOTFALL OUT SCENE ARGS...: a run that keeps itself twice is compared with what is made of its first checkpoint: history, surfaces,
# pictures and energies of the grains, byte by byte, and the memory in the second checkpoint but for wall times.
set -u
footfall=$1 out=$2; shift 2
die() { echo "$*"; exit 1; }
rm -rf "$out" "$out.straight" && mkdir -p "$(dirname "$out")"
"$footfall" run "$@" --set output.plots=false --out "$out" --quiet || die "the run failed with code $?"
mapfile -t sets < <(ls "$out/checkpoint" | sort -n)
[[ ${#sets[@]} == 2 ]] || die "expected two checkpoints, found: ${sets[*]}"
cp -r "$out" "$out.straight"
rm -r "$out/checkpoint/${sets[1]}"
"$footfall" run --resume "$out" --quiet || die "the resumed run failed with code $?"

differ=0
compare() { cmp "$1" "$2" || differ=1; }
while IFS= read -r file; do
  case $file in
    ./.footfall.* | ./liggghts*.log | ./summary.json | ./ledger.csv | */checksums.txt | */start.json) ;;
    */run.txt) compare <(grep -v 'times/\|_seconds\|waited' "$out/$file") <(grep -v 'times/\|_seconds\|waited' "$out.straight/$file") ;;
    *) compare "$out/$file" "$out.straight/$file" ;;
  esac
done < <(cd "$out.straight" && find . -type f)
compare <(grep -v wall_s "$out/summary.json") <(grep -v wall_s "$out.straight/summary.json")
[[ $(wc -l <"$out/history.csv") -gt 10 ]] || die "the history has hardly a row"
rm -rf "$out" "$out.straight"
exit $differ
