#!/usr/bin/env bash
# stopped_partner.sh FOOTFALL OUT PROGRAM: one program of a coupled run is stopped (SIGSTOP). After coupling.timeout the other says so, the
# run ends with exit code 1, and nothing is left behind.
set -u
footfall=$1 out=$2 program=$3
here=$(cd "$(dirname "$0")" && pwd)
mark=${out##*/}/run  # in the command line of every process of the run, which may have the path from elsewhere
die() { echo "$*"; cat "$out/said.txt"; pkill -KILL -f "$mark" ; exit 1; }
rm -rf "$out" && mkdir -p "$out"
"$footfall" run "$here/../bad_input/plate_on_grains.scene" --set particles.script="\"$here/endless.in\"" --set end_time=1000 \
  --set coupling.timeout=2 --out "$out/run" >"$out/said.txt" 2>&1 &
run=$!
until [[ -f $out/run/history.csv && $(wc -l <"$out/run/history.csv") -gt 3 ]]; do
  kill -0 "$run" 2>/dev/null || die "the run ended before it was under way"
  sleep 0.1
done
stopped=$(pgrep -f "bin/$program .*$mark" | while read -r pid; do [[ $(readlink "/proc/$pid/exe") == */$program ]] && echo "$pid"; done | head -n 1)
[[ -n $stopped ]] || die "$program was not found"
kill -STOP "$stopped"
start=$SECONDS
wait "$run"
code=$?
echo "$program stopped: ended with code $code after $((SECONDS - start)) s"
[[ $code == 1 ]] || die "exit code $code, expected 1"
grep -q 'has said nothing for\|nothing for 2' "$out/said.txt" || die "no message tells of the silent partner"
pgrep -f "$mark" >/dev/null && die "a process is left: $(pgrep -af "$mark")"
exit 0
