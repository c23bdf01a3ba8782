#!/usr/bin/env bash
# Wall and processor time of the coupled landing, and of stock LIGGGHTS on the same bed, with four stock meshes moved as the pads of the coupled run were
# (`fix move/mesh linear/variable`): the same steps, about the same impact, so about as many neighbour lists. A B A B ..., ratios pair by pair, their medians.
#   tests/bench/stock_ratio.sh BUILD BED.restart [-r RANKS] [-n SUBSTEPS] [-p PAIRS] [-t SECONDS] [-s STORE] [-- extra words for mbd_solver]
#     -r  ranks of LIGGGHTS on both sides (default 2); the mechanism has one more
#     -n  substeps of a window (default: as in the script)
#     -p  pairs (default 3); ten tell one per cent on a quiet machine
#     -t  simulated time [s] (default 0.1)
#     -c  counts instructions of LIGGGHTS instead (valgrind's callgrind, one rank, one pair): a ratio that does not depend on what else the machine does;
#         try -t 0.01
#     -s  a file that keeps the medians of every call; what changed since the last call of the same kind is told
# BED.restart and BED.restart.grains are what `footfall run` keeps (its printed line names them).
set -eu
export LC_ALL=C.UTF-8  # decimal points of awk
(( $# >= 2 )) || { sed -n '2,12p' "$0"; exit 2; }
build=$(realpath "$1") bed=$(realpath "$2"); shift 2
ranks=2 pairs=3 seconds=0.1 store= count= every=
while getopts r:n:p:t:cs: option; do
  case $option in
    c) count=yes ranks=1 pairs=1 ;; r) ranks=$OPTARG ;; n) every=$OPTARG ;; p) pairs=$OPTARG ;; t) seconds=$OPTARG ;; s) store=$(realpath -m "$OPTARG") ;;
    *) exit 2 ;;
  esac
done
shift $((OPTIND - 1))
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
steps=$(awk -v t="$seconds" 'BEGIN { printf "%d", t / 1e-4 + 0.5 }')
# Open MPI refuses root unless told.
(( EUID )) || export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
mpi="mpirun --oversubscribe --bind-to none -np $ranks"

# The pad's disc: ring k holds 6 k vertices, as the scene's boundary.
awk 'function v(k, i,   a) { if (k == 0) return "0 0 0"; a = 2 * 3.14159265358979 * i / (6 * k); return sprintf("%.9g %.9g 0", 0.05 * k * cos(a), 0.05 * k * sin(a)) }
     function t(a, b, c) { printf "facet normal 0 0 1\nouter loop\nvertex %s\nvertex %s\nvertex %s\nendloop\nendfacet\n", a, b, c }
     BEGIN { print "solid pad"
       for (k = 1; k <= 4; ++k) for (s = 0; s < 6; ++s) {
         for (i = 0; i < k; ++i) t(v(k - 1, (s * (k - 1) + i) % (k > 1 ? 6 * (k - 1) : 1)), v(k, s * k + i), v(k, (s * k + i + 1) % (6 * k)))
         for (i = 0; i < k - 1; ++i) t(v(k - 1, s * (k - 1) + i), v(k, (s * k + i + 1) % (6 * k)), v(k - 1, (s * (k - 1) + i + 1) % (6 * (k - 1))))
       }
       print "endsolid pad" }' > "$work/pad.stl"

# "WALL PROCESSOR" [s] of a command and all its children.
seconds_of() {
  local TIMEFORMAT='%R %U %S'
  { time "$@" > "$work/out" 2>&1; } 2> "$work/time" || { cat "$work/out" >&2; exit 1; }
  awk '{ print $1, $2 + $3 }' "$work/time"
}
counted() { [[ -z $count ]] || echo "valgrind --tool=callgrind --callgrind-out-file=$work/$1"; }
# The pads start 5 mm above the highest grain under the first of them, as the lander does.
height=$(awk '($1 - 1.2374)^2 + ($2 - 1.2374)^2 < 0.04 && $3 + $4 > top { top = $3 + $4 } END { print top + 0.005 }' "$bed.grains")

cd "$work"
for pair in $(seq "$pairs"); do
  rm -rf "$work/run"
  ours=$(seconds_of $mpi $(counted ours.count) "$build/bin/liggghts_mbd" -in "$root/inputs/landing_script/in.regolith" -var here "$root/inputs/landing_script" -var bed "$bed" -var frames 0 ${every:+-var every "$every"} -log ours.log : \
    -np 1 "$build/bin/mbd_solver" "$root/inputs/landing_script" --quiet --until "$seconds" --set particles.grains="$bed.grains" ${every:+--set "particles.variables.every=$every"} --out "$work/run" "$@")
  # Slope changes at every second row of the history for 60 ms, then at every tenth.
  awk -F, -v dt=1e-4 '
    NR == 2 { for (c = 1; c <= NF; ++c) if (match($c, /^footpad_[1-4]\.v[xyz]$/)) name[c] = substr($c, 11) substr($c, 9, 1) }
    NR > 2 && ((NR - 3) % ($1 < 0.06 ? 2 : 10) == 0) { t[n] = $1; for (c in name) v[c, n] = $c; ++n }
    END {
      for (c in name) {
        printf "variable %s equal %.6g", name[c], v[c, 0]
        before = 0
        for (i = 0; i + 1 < n; ++i) {
          slope = (v[c, i + 1] - v[c, i]) / (t[i + 1] - t[i])
          printf "+(%.6g)*(step*%g-%.6g)*(step*%g>%.6g)", slope - before, dt, t[i], dt, t[i] - 1e-9
          before = slope
        }
        printf "\n"
      }
    }' run/history.csv > motion.lammps
  stock=$(seconds_of $mpi $(counted stock.count) liggghts -in "$root/tests/bench/in.stock_landing" -var here "$root/inputs/landing_script" -var bed "$bed" -var pad pad.stl -var height "$height" -var steps "$steps" -log stock.log)
  if [[ -n $count ]]; then
    read -r ours stock < <(sed -n 's/^summary: //p' ours.count stock.count | paste -sd' ')
    awk -v a="$ours" -v b="$stock" -v t="$seconds" 'BEGIN { printf "%g s, instructions of LIGGGHTS on one rank: coupled %.6g, stock %.6g, ratio %.4f\n", t, a, b, a / b }'
    exit
  fi
  parts=$(grep -E '"(dem|waited|mbd)_wall_s"' run/summary.json | tr -d ' \n"' | sed 's/_wall_s:/ /g')
  echo "$ours $stock" >> pairs.txt
  awk -v a="$ours" -v b="$stock" -v parts="$parts" -v lists="$(sed -n 's/Neighbor list builds = //p' ours.log)" -v stock_lists="$(sed -n 's/Neighbor list builds = //p' stock.log)" '
    BEGIN { split(a, x); split(b, y); printf "coupled %.2f s  stock %.2f s  ratio %.3f  processor %.3f  [s]: %s  neighbour lists %d and %d\n", x[1], y[1], x[1] / y[1], x[2] / y[2], parts, lists, stock_lists }'
done

median() { awk -v a="$1" -v b="$2" '{ print $a / $b }' pairs.txt | sort -g | awk '{ v[NR] = $1 } END { printf "%.3f", (v[int((NR + 1) / 2)] + v[int((NR + 2) / 2)]) / 2 }'; }
kind="$ranks ranks, $seconds s${every:+, n = $every}${*:+, $*}" wall=$(median 1 3) processor=$(median 2 4)
machine="$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores"
echo "$kind: median of $pairs pairs: wall $wall, processor $processor ($machine)"
if [[ -n $store ]]; then
  before=$(grep -F "| $kind |" "$store" 2>/dev/null | tail -n 1 || true)
  [[ -z $before ]] || echo "before: $before"
  [[ -f $store ]] || printf '| date | revision | kind | pairs | wall | processor | machine |\n|---|---|---|---|---|---|---|\n' > "$store"
  echo "| $(date +%F) | $(git -C "$root" rev-parse --short HEAD 2>/dev/null || echo -) | $kind | $pairs | $wall | $processor | $machine |" >> "$store"
fi
