#!/usr/bin/env bash
# What an error costs each curve of a study: windows and run times where the measure crosses it, straight between the points of the CSV on logarithmic scales,
# and their ratios to the first curve.
#   ./footfall accuracy inputs/accuracy/coupling_lattice.toml --out DIR && tests/bench/time_at_error.sh DIR/coupling_lattice.csv [ERROR [MEASURE]]
set -eu
export LC_ALL=C.UTF-8  # decimal points of awk
csv=$1 error=${2:-0.01} measure=${3:-motion}
awk -F, -v e="$error" -v measure="error.$measure" '
  function at(a, b, s) { return exp(log(a) + s * (log(b) - log(a))) }
  NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
  {
    now = $column[measure]; own = $column["mbd_wall_s"] + $column["exchange_wall_s"]
    if ($1 == curve && before > e && now <= e) {
      s = (log(before) - log(e)) / (log(before) - log(now))
      w = at(windows, $column["windows"], s); o = at(cost, own, s); a = at(whole, $column["wall_s"], s)
      if (!first) { first = $1; w0 = w; o0 = o; a0 = a }
      printf "%-16s %6.0f windows (%.3f)  mechanism + exchange %.4f s (%.3f)  whole %.3f s (%.3f), grains %.0f %%\n", $1, w, w / w0, o, o / o0, a, a / a0, 100 * (1 - o / a)
    }
    curve = $1; before = now; windows = $column["windows"]; cost = own; whole = $column["wall_s"]
  }' "$csv"
