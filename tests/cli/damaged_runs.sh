#!/usr/bin/env bash
# damaged_runs.sh FOOTFALL OUT: summaries that are cut or strange are told with exit code 2; one of a sweep is done again and stops nothing; a path that
# LIGGGHTS would take apart is told before anything is made.
set -u
footfall=$1 out=$2 here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$out" && mkdir -p "$out" && cd "$out" || exit 1
die() { echo "damaged_runs.sh: $*"; cat ./*.txt; exit 1; }
"$footfall" run "$here/../../inputs/accuracy/scenes/slider_crank.toml" --quiet --until 0.02 --out good >good.txt 2>&1 || die "the run failed"
tried=0
try() {
  rm -rf bad && cp -r good bad && printf '%s\n' "$1" > bad/summary.json
  for command in report pictures compare; do
    code=0
    "$footfall" "$command" bad >said.txt 2>&1 || code=$?
    # A page needs little of a summary.
    [[ $code == 2 || ($command == report && $code == 0) ]] || die "$command ended with $code on: $(head -c 80 bad/summary.json)"
    tried=$((tried + 1))
  done
}
try "$(head -c 200 good/summary.json)"
try '[1, 2]'
try '{}'
try '{"status": 3, "scene": 4, "versions": [], "warnings": 7, "active": "x"}'
try '{"status": "done", "scene": {}, "dt_dem_s": "x", "max_omega_h": {"a": "b"}}'
try '{"status": "done", "scene": {"particles": {}}, "dt_dem_s": 1e-5}'
((tried == 18)) || die "tried $tried"

"$footfall" sweep "$here/study_small.toml" --out sweep >sweep.txt 2>&1 || die "the sweep"
cut=sweep/runs/time_tolerance_0.001/summary.json
head -c 300 "$cut" > part && mv part "$cut"
"$footfall" report sweep >report.txt 2>&1 || die "the page of a sweep with a cut summary"
grep -q damaged sweep/report.html || die "the page does not say that a run is damaged"
"$footfall" sweep "$here/study_small.toml" --out sweep --merge >merge.txt 2>&1
[[ $? -le 1 ]] || die "one cut summary stops the tables of all"
"$footfall" sweep "$here/study_small.toml" --out sweep >sweep.txt 2>&1 || die "the sweep with a cut summary"
grep -q "1 runs to do" sweep.txt || die "the cut run was not done again"

grains=("$here/../bad_input/plate_on_grains.scene" --set "particles.script=\"$here/replay/in.plate\"" --quiet)
"$footfall" run "${grains[@]}" --out "a b" >blank.txt 2>&1
[[ $? == 2 && ! -e "a b" ]] || die "a blank in --out was not refused, or left something"
grep -q 'is "a b", but LIGGGHTS takes its script apart at blanks' blank.txt || die "the message does not say why"
exit 0
