#!/usr/bin/env bash
# Wall and processor time of a coupled scene with one mesh, and of stock LIGGGHTS on the same bed, whose mesh moves as in the coupled run: means
# of its velocities over twenty parts of the run. A B A B ..., ratios pair by pair, their medians. The landing: stock_ratio.sh.
#   tests/bench/scene_ratio.sh BUILD SCENE [-r RANKS] [-p PAIRS] [-t SECONDS] [-- extra words for footfall run]
set -eu
export LC_ALL=C.UTF-8  # decimal points of awk
(( $# >= 2 )) || { sed -n '2,4p' "$0"; exit 2; }
build=$(realpath "$1") scene=$2; shift 2
ranks=2 pairs=3 seconds=0.2
while getopts r:p:t: option; do
  case $option in r) ranks=$OPTARG ;; p) pairs=$OPTARG ;; t) seconds=$OPTARG ;; *) exit 2 ;; esac
done
shift $((OPTIND - 1))
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
(( EUID )) || export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
coupled=("$build/bin/footfall" run "$scene" --ranks "$ranks" --until "$seconds" --quiet --set output.plots=false --set output.vtk=false "$@")

# "WALL PROCESSOR" [s] of a command and all its children.
seconds_of() {
  local TIMEFORMAT='%R %U %S'
  { time "$@" > "$work/out" 2>&1; } 2> "$work/time" || { cat "$work/out" >&2; exit 1; }
  awk '{ print $1, $2 + $3 }' "$work/time"
}

# Once: the bed, the motion, the stock script of `compare`, and that without its file of forces and with one `run`.
"${coupled[@]}" --out "$work/run" > "$work/out"
"$build/bin/footfall" compare "$work/run" > "$work/out"
command=$(grep -o 'mpirun .*' "$work/out" | head -n 1)
dt=$(grep -o -- '-var dt [^ ]*' <<<"$command" | awk '{ print $3 }')
steps=$(sed -n 's/^run \([0-9]*\) .*/\1/p' "$work/run/compare/in.stock")
window=$(sed -n 's/^# The motion of the coupled run: velocities for every \([0-9]*\) steps.*/\1/p' "$work/run/compare/in.stock")
mean() {  # of a file of velocities: a sum of steps, one for each part of the run
  awk -v n="$window" -v steps="$steps" '{ k = int((NR - 1) * n * 20 / steps); if (k > 19) k = 19; sum[k] += $1; ++count[k] }
    END { before = 0; for (k = 0; k < 20; ++k) { v = count[k] ? sum[k] / count[k] : before; printf "+(%.6g)*(step>=%d)", v - before, k * steps / 20; before = v } }' "$1"
}
while read -r line; do
  case $line in
    "variable replay1_"*" file "*) name=$(awk '{ print $2 }' <<<"$line"); echo "variable $name equal 0$(mean "$work/run/compare/${name}.txt")" ;;
    "fix replay_forces"*) ;;
    "run $steps "*) echo "run $steps" ;;
    *) printf '%s\n' "$line" ;;
  esac
done < "$work/run/compare/in.stock" > "$work/run/compare/in.timed"
command=${command//in.stock/in.timed}

for pair in $(seq "$pairs"); do
  ours=$(seconds_of "${coupled[@]}" --out "$work/run_$pair")
  stock=$(seconds_of bash -c "$command")
  rm -rf "$work/run_$pair"
  echo "$ours $stock" >> "$work/pairs"
  awk -v a="$ours" -v b="$stock" 'BEGIN { split(a, x); split(b, y); printf "coupled %.2f s  stock %.2f s  ratio %.3f  processor %.3f\n", x[1], y[1], x[1] / y[1], x[2] / y[2] }'
done
median() { awk -v a="$1" -v b="$2" '{ print $a / $b }' "$work/pairs" | sort -g | awk '{ v[NR] = $1 } END { printf "%.3f", (v[int((NR + 1) / 2)] + v[int((NR + 2) / 2)]) / 2 }'; }
echo "$scene, $ranks ranks, $seconds s, $steps steps of $dt s: median of $pairs pairs: wall $(median 1 3), processor $(median 2 4)"
