#!/usr/bin/env bash
# A study with --resume keeps the runs that were done with the same settings, and does those again whose settings have changed.
#   study.sh FOOTFALL FILE
set -eu
footfall=$1 file=$2
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
die() { echo "study.sh: $*" >&2; cat "$work"/*.txt >&2; exit 1; }
study() { "$footfall" accuracy "$1" --out "$work/study" "${@:2}" > "$work/out.txt" 2>&1 || die "accuracy $* ended with $?"; }
# Seconds and nanoseconds at which the runs wrote their summaries.
times() { stat -c '%n %y' "$work"/study/runs/*/summary.json; }

study "$file"
[[ $(times | wc -l) == 3 ]] || die "expected three runs: the reference is one of the values"
[[ -e $work/study/runs/time_tolerance_0.001/summary.json ]] || die "folders have no blanks: LIGGGHTS splits paths there"
first=$(times) table=$(cat "$work/study/study_small.csv")

study "$file" --resume
[[ $(times) == "$first" ]] || die "--resume did finished runs again"
[[ $(cat "$work/study/study_small.csv") == "$table" ]] || die "--resume gave another table"

study "$file"
for run in $(times | cut -d' ' -f1); do ! grep -qF "$(times | grep -F "$run")" <<< "$first" || die "without --resume $run was kept"; done

# Another setting for all, beside the scene: everything is done again.
again=$(times)
sed -e "s#^scene = .*#scene = \"$(cd "$(dirname "$file")" && pwd)/../../inputs/accuracy/scenes/slider_crank.toml\"#" -e 's/^until = .*/until = 0.03/' "$file" > "$work/study_small.toml"
study "$work/study_small.toml" --resume
for run in $(times | cut -d' ' -f1); do ! grep -qF "$(times | grep -F "$run")" <<< "$again" || die "$run was kept although it ends later now"; done
