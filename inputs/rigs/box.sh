#!/usr/bin/env bash
# Friction angle and cohesion from the runs of inputs/rigs/box.toml: tau = c + sigma tan(phi) by least squares on each sample of the bed; mean and 95 % interval by Student's t.
#   inputs/rigs/box.sh DIR     DIR: where `footfall sweep inputs/rigs/box.toml --out DIR` put its runs
# Means over the last 40 % of a run, over the area of the box: tau of the horizontal force on the tray, sigma of the vertical one less the weight of the lower half of the grains.
set -euo pipefail
dir=$1
side=0.12 density=2600 radius=0.005 g=9.81
{
  read -r _
  while IFS=, read -r _ load seed status _ grains; do
    [[ $status == done ]] || { echo "load $load, seed $seed: $status" >&2; exit 1; }
    awk -F, -v load="$load" -v seed="$seed" -v n="$grains" -v side=$side -v rho=$density -v r=$radius -v g=$g '
      /^#/ { next }
      !named { for (i = 1; i <= NF; ++i) at[$i] = i; named = 1; next }
      { t[++rows] = $at["time"]; x[rows] = $at["tray.contact.fx"]; z[rows] = $at["tray.contact.fz"] }
      END {
        for (k = 1; k <= rows; ++k) if (t[k] >= 0.6 * t[rows]) { sx += x[k]; sz += z[k]; ++late }
        weight = n * rho * 4 / 3 * 3.14159265 * r^3 * g
        printf "%s %s %.6g %.6g\n", seed, load, (-sz / late - weight / 2) / side^2, (sx < 0 ? -sx : sx) / late / side^2
      }' "$dir/runs/load_${load}__seed_$seed/history.csv"
  done
} < "$dir/runs.csv" | awk '
  function tell(name, unit, v, count,   k, mean, s) {
    for (k = 1; k <= count; ++k) mean += v[k] / count
    for (k = 1; k <= count; ++k) s += (v[k] - mean)^2
    split("0 12.706 4.303 3.182 2.776 2.571 2.447 2.365 2.306 2.262", student, " ")
    printf "| %s | %s | %.4g | %s | %d |\n", name, unit, mean, (count > 1 ? sprintf("%.2g", student[count] * sqrt(s / (count - 1) / count)) : ""), count
  }
  { if (!($1 in known)) { known[$1] = 1; seeds[++samples] = $1 }
    n[$1]++; s[$1] += $3; q[$1] += $3^2; t[$1] += $4; st[$1] += $3 * $4; tt[$1] += $4^2
    if (!($2 in load)) { load[$2] = 1; loads[++many] = $2 }
    sigma[$2, $1] = $3; tau[$2, $1] = $4 }
  END {
    print "| answer | unit | mean | 95 % interval: +- | samples |\n|---|---|---|---|---|"
    for (k = 1; k <= samples; ++k) {
      i = seeds[k]; d = n[i] * q[i] - s[i]^2
      if (n[i] < 2) { print "inputs/rigs/box.sh: two loads or more are needed" > "/dev/stderr"; exit 1 }
      slope = (n[i] * st[i] - s[i] * t[i]) / d; c[k] = (t[i] - slope * s[i]) / n[i]
      phi[k] = atan2(slope, 1) * 180 / 3.14159265
      rest = tt[i] - c[k] * t[i] - slope * st[i]; all = tt[i] - t[i]^2 / n[i]; r2[k] = all > 0 ? 1 - rest / all : 0
    }
    tell("friction angle phi", "deg", phi, samples); tell("cohesion c", "Pa", c, samples); tell("R^2", "", r2, samples)
    for (j = 1; j <= many; ++j) {
      for (k = 1; k <= samples; ++k) { a[k] = sigma[loads[j], seeds[k]]; b[k] = tau[loads[j], seeds[k]] / a[k] }
      tell("sigma, load of " loads[j] " N", "Pa", a, samples); tell("tau / sigma, load of " loads[j] " N", "", b, samples)
    }
  }'
