#!/usr/bin/env bash
# What an open page of `run --view` costs the run: pairs without and with the page in a headless Chromium that was started before, in turn, and the medians
# of their ratios: processor time (user + system) of the programs of the run, without footfall and the browser; processor time of footfall; wall-clock time of the run.
#   tests/bench/live_page.sh BUILD [-p PAIRS] [-t SECONDS] [-s SCENE] [-- extra words for footfall run]
set -eu
export LC_ALL=C.UTF-8  # decimal points of awk
(( $# >= 1 )) || { sed -n '2,4p' "$0"; exit 2; }
for program in chromium curl; do command -v $program >/dev/null || { echo "live_page.sh: $program is missing"; exit 77; }; done
build=$(realpath "$1"); shift
pairs=5 seconds=0.2 scene=$(cd "$(dirname "$0")/../.." && pwd)/inputs/landing_mr
while getopts p:t:s: option; do
  case $option in p) pairs=$OPTARG ;; t) seconds=$OPTARG ;; s) scene=$OPTARG ;; *) exit 2 ;; esac
done
shift $((OPTIND - 1))
work=$(mktemp -d) browser=''; trap '[[ -z $browser ]] || kill $browser; rm -rf "$work"' EXIT
(( EUID )) || export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
run=("$build/bin/footfall" run "$scene" --ranks 1 --until "$seconds" --quiet --set output.plots=false "$@")

# Starts the browser, without a page.
start_browser() {
  rm -rf "$work/profile"
  chromium --headless --no-sandbox --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --user-data-dir="$work/profile" --remote-debugging-port=0 about:blank \
    >"$work/browser" 2>&1 &
  browser=$!
  disown $browser
  until [[ -s $work/profile/DevToolsActivePort ]]; do sleep 0.1; done
  sleep 2
}

# "PROGRAMS FOOTFALL WALL" [s] of a run into the folder $1; with a second word the page is open. footfall's own processor time is read while it runs, ten times a second: it
# hardly works at its end.
measured() {
  local out=$work/$1 view=${2:+--view} footfall='' own=0 opened='' address stat
  rm -rf "$out" "$work/said"
  [[ -z $view ]] || start_browser
  (
    TIMEFORMAT='%U %S'
    time "${run[@]}" $view --out "$out" >"$work/said" 2>&1
  ) 2>"$work/time" &
  local shell=$!
  while [[ -e /proc/$shell ]]; do
    [[ -n $footfall ]] || footfall=$(pgrep -P $shell -x footfall) || true
    if [[ -n $footfall ]] && read -r stat <"/proc/$footfall/stat"; then
      read -ra stat <<<"${stat##*) }"
      [[ ${stat[0]} == Z ]] || own=$((stat[11] + stat[12]))
    fi 2>/dev/null
    if [[ -n $view && -z $opened ]] && address=$(grep -om1 'http://127[^ ]*' "$work/said"); then
      opened=yes
      curl -sfX PUT "http://127.0.0.1:$(head -n 1 "$work/profile/DevToolsActivePort")/json/new?$address" >/dev/null
    fi
    sleep 0.1
  done
  wait $shell || { cat "$work/said" >&2; exit 1; }
  [[ -z $view || -n $opened ]] || { echo "live_page.sh: the run gave no address" >&2; exit 1; }
  if [[ -n $browser ]]; then kill $browser; browser=''; sleep 1; fi
  awk -v own="$own" -v tick="$(getconf CLK_TCK)" '{ printf "%.2f %.2f ", $1 + $2 - own / tick, own / tick }' "$work/time"
  sed -n 's/^ *"wall_s": \([0-9.e+-]*\),*/\1/p' "$out/summary.json"
}
median() { sort -g | awk '{ v[NR] = $1 } END { print NR % 2 ? v[(NR + 1) / 2] : (v[NR / 2] + v[NR / 2 + 1]) / 2 }'; }

measured bed >/dev/null  # makes the bed of grains, unless it is cached
echo "programs [s], footfall [s], wall clock [s]: without a page | with the page | ratios of programs and wall clock"
for (( k = 1; k <= pairs; ++k )); do
  alone=$(measured alone) open=$(measured open view)
  cmp -s "$work/alone/history.csv" "$work/open/history.csv" || { echo "live_page.sh: the page changes the history" >&2; exit 1; }
  echo "$alone $open" | awk '{ printf "%s %s %s | %s %s %s | %.4f %.4f\n", $1, $2, $3, $4, $5, $6, $4 / $1, $6 / $3 }' | tee -a "$work/pairs"
done
for column in programs:7 wall-clock:8; do
  echo "median ratio, ${column%:*}: $(awk -v c="${column#*:}" '{ gsub(/\|/, " "); print $c }' "$work/pairs" | median)"
done
