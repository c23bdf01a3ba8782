#!/usr/bin/env bash
# checkpoints.sh FOOTFALL OUT WINDOW SCENE ARGS...: a run whose scene sets no checkpoint interval saves checkpoints by the wall clock. They change nothing that it writes;
# after a kill it is resumed from one as the undisturbed run continues, within the tolerances below; with grains it is to the byte the run that an ordinary checkpoint after
# the same window makes; a run that is done leaves none.
#   WINDOW   length of a window [s]; 0 without grains
set -u
export LC_ALL=C.UTF-8  # decimal points of awk
source "$(dirname "$0")/coupled_run.sh"
footfall=$1 out=$2 window=$3; shift 3
# Of every column, over the largest value of its unit. Without grains to the end: the integrator's own tolerance (1e-6), as an impact spreads it. With grains in the first
# window what Newton leaves, which begins with a new matrix: no printed digit of rigid bodies; of bodies that bend 8e-7 at the default rtol, at most 1.3e-10 at
# rtol = 1e-9, with which they run here. Then LIGGGHTS' new lists of neighbours show: a new contact is found with another list, or summed in another order. Of 52 checkpoints
# in this impact four were beyond 1e-6 in the third window, the largest 2.6e-5.
tolerance=1e-3 tolerance_at_once=1e-9 tolerance_of_lists=1e-4
die() { echo "$*"; cat "$out"/*.txt; end_all; exit 1; }
rm -rf "$out" && mkdir -p "$out" && cd "$out" || exit 1
scene=("$@")
run() { "$footfall" run "${scene[@]}" --set output.plots=false --set output.interval=1e-4 --quiet "$@"; }
run --keep-every 0 --out "$out/never" >"$out/never.txt" 2>&1 || die "the run failed with code $?"
[[ -e $out/never/checkpoint ]] && die "--keep-every 0 has saved a checkpoint"
run --keep-every 0.01 --out "$out/saved" >"$out/saved.txt" 2>&1 || die "the run with checkpoints failed with code $?"
cmp "$out/never/history.csv" "$out/saved/history.csv" || die "checkpoints change the history"
[[ -e $out/saved/checkpoint ]] && die "checkpoints of a run that is done are left: $(ls "$out/saved/checkpoint")"

run --keep-every 0.05 --out "$out/killed" >"$out/killed.txt" 2>&1 &
front=$!
until [[ $(ls "$out/killed/checkpoint" 2>/dev/null | grep -vc part) -ge 1 ]]; do kill -0 $front 2>/dev/null || die "the run ended before its first checkpoint"; sleep 0.01; done
kill -KILL $(processes_of mbd_solver) || die "mbd_solver was not found"
wait $front && die "a killed run ended well"
after=$(ls "$out/killed/checkpoint" | grep -v part | sort -n | tail -n 1)
"$footfall" run --resume "$out/killed" --keep-every 0 --quiet >"$out/resumed.txt" 2>&1 || die "the resumed run failed with code $?"
# differences FROM UNTIL TOLERANCE UNITS: of rows with FROM < time < UNTIL [s] in columns of these units (empty: all)
differences() {
  awk -F, -v from="$1" -v until="$2" -v tolerance="$3" -v units="$4" '
    function size(x) { return x < 0 ? -x : x }
    NR == 1 { sub(/^# units: /, ""); split($0, unit, ",") }
    NR == 2 { split($0, name, ",") }
    FNR < 3 { next }
    NR == FNR { rows = FNR; for (i = 1; i <= NF; ++i) { a[FNR, i] = $i; if (size($i) > big[unit[i]]) big[unit[i]] = size($i) }; next }
    { last = FNR }
    $1 > from && $1 < until { ++compared; for (i = 1; i <= NF; ++i) if ((units == "" || index(units, " " unit[i] " ")) && big[unit[i]] > 0 && size($i - a[FNR, i]) / big[unit[i]] > worst) { worst = size($i - a[FNR, i]) / big[unit[i]]; where = name[i] " at " $1 " s" } }
    END {
      printf "%d rows: largest difference %.2g of the largest value, %s\n", compared, worst, where
      if (last != rows) { print "rows: " last " instead of " rows; exit 1 }
      exit !compared || worst > tolerance
    }' "$out/never/history.csv" "$out/killed/history.csv"
}
if [[ $window == 0 ]]; then
  differences 0 1e9 $tolerance " m J " || die "the resumed run comes to another end"
else
  read -r from next until < <(awk -v n="$after" -v h="$window" 'BEGIN { print n * h, (n + 1.5) * h, (n + 3.5) * h }')
  differences "$from" "$next" $tolerance_at_once "" || die "the resumed run does not begin as the undisturbed one continues"
  differences "$from" "$until" $tolerance_of_lists "" || die "the resumed run does not go on as the undisturbed one"
  # A checkpoint after the same window; the next one comes after the rows that are compared.
  interval=$(awk -v n="$after" -v h="$window" 'BEGIN { print (n - 0.5) * h }')
  run --keep-every 0 --set output.checkpoint_interval="$interval" --out "$out/ordinary" >"$out/ordinary.txt" 2>&1 || die "the run with an ordinary checkpoint failed"
  compared() { awk -F, -v end="$(awk -v i="$interval" 'BEGIN { print 2 * i }')" 'FNR < 3 || $1 < end' "$1/history.csv"; }
  cmp <(compared "$out/killed") <(compared "$out/ordinary") || die "it is not the run that an ordinary checkpoint after window $after makes"
fi
rm -rf "$out"
exit 0
