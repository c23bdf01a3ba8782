#!/usr/bin/env bash
# rtol.sh MBD_SOLVER SCENE OUT: solver.rtol alone makes a scene more exact, by both integrators: the end of the history against that at 1e-11.
set -u
solver=$1 scene=$2 out=$3
rm -rf "$out" && mkdir -p "$out" || exit 1
end_at() { # INTEGRATOR RTOL
  "$solver" "$scene" --quiet --out "$out/$1_$2" --set solver.integrator="\"$1\"" --set solver.rtol="$2" --set solver.max_step=1 >"$out/said.txt" 2>&1 ||
    { cat "$out/said.txt" >&2; exit 1; }
  tail -n 1 "$out/$1_$2/history.csv"
}
reference=$(end_at one_step 1e-11) || exit 1
for integrator in one_step ida; do
  last=1
  for rtol in 1e-4 1e-6 1e-8 1e-10; do
    line=$(end_at "$integrator" "$rtol") || exit 1
    # Positions of three bodies, of about 1 m: columns 2 to 4 of the first. Ten digits are written.
    error=$(paste -d' ' <(cut -d, -f2-4 <<<"$line" | tr , '\n') <(cut -d, -f2-4 <<<"$reference" | tr , '\n') |
      awk '{ d = $1 - $2; if (d < 0) d = -d; if (d > most) most = d } END { print most + 0 }')
    echo "$integrator, rtol $rtol: off by $error m"
    awk -v e="$error" -v last="$last" -v rtol="$rtol" 'BEGIN { exit !(e < 100 * rtol && (e < 0.3 * last || e < 1e-9)) }' ||
      { echo "rtol.sh: $integrator is not more exact at $rtol"; exit 1; }
    last=$error
  done
done
