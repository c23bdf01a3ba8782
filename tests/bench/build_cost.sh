#!/usr/bin/env bash
# build_cost.sh [BUILD]: where the seconds of a first build go. Configures as `./footfall run` does, without compiler cache, builds what a run needs on
# two cores and prints the processor time (user + system) of every object, the longest first, then the sum of all, and the wall-clock time.
# The processor time hardly depends on what else the machine does; the time on the clock does.
set -euo pipefail
here=$(cd "$(dirname "$0")/../.." && pwd)
build=${1:-$(mktemp -d)}
[[ -n ${1-} ]] || trap 'rm -rf "$build"' EXIT
mkdir -p "$build"
# Stands before the compiler: one line per call, user and system seconds and what was made.
cat > "$build/timed" <<'SH'
#!/usr/bin/env bash
made=linked
for ((k = 1; k <= $#; ++k)); do [[ ${!k} != -o ]] || { next=$((k + 1)); made=${!next}; }; done
TIMEFORMAT="%U %S %R $made"
{ time "$@" 2>&3; } 3>&2 2>> "$(dirname "$0")/costs"
SH
chmod +x "$build/timed"
: > "$build/costs"
began=$(date +%s.%N)
cmake --preset user -S "$here" -B "$build" -DCMAKE_CXX_COMPILER="${CXX:-clang++}" \
  -DCMAKE_CXX_COMPILER_LAUNCHER="$build/timed" -DCMAKE_CXX_LINKER_LAUNCHER="$build/timed" > "$build/log" || { tail -n 30 "$build/log"; exit 1; }
configured=$(date +%s.%N)
cmake --build "$build" -j 2 --target footfall mbd_solver liggghts_mbd >> "$build/log" 2>&1 || { tail -n 30 "$build/log"; exit 1; }
ended=$(date +%s.%N)
sort -rn "$build/costs" | awk '{ n = split($4, part, "/"); printf "%7.1f s  %s\n", $1 + $2, part[n - 2] "/" part[n - 1] "/" part[n] }' | sort -rn
awk -v a="$began" -v b="$configured" -v c="$ended" \
  '{ sum += $1 + $2 } END { printf "processor time of %d objects %.0f s; on the clock: configured in %.0f s, built in %.0f s\n", NR, sum, b - a, c - b }' "$build/costs"
