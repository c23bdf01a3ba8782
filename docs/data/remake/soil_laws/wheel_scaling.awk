# histories of inputs/laws/wheel_scaling.toml or wheel_stiffness.toml, one after another -> speed V and power P of each wheel, over what the law says of them by wheel "one" on the same sample
# of the bed. Means over the last 40 % of a run. P = omega |M_y|, M_y the moment of the grains about the axle.
function finish(   k) {
  if (wheel == "") return
  first = int(0.6 * rows)
  for (k = first; k < rows; ++k) { speed += vx[k]; moment += my[k]; turning += wy[k] }
  k = rows - first
  V[wheel, seed] = speed / k; P[wheel, seed] = turning / k * (moment < 0 ? -moment : moment) / k
  slip[wheel, seed] = 1 - V[wheel, seed] / (turning / k * r[wheel] * 0.08)
  speed = moment = turning = rows = 0
}
BEGIN {
  FS = ","
  r["one"] = r["one on stiffer grains"] = r["wider"] = r["on the Moon"] = 1; r["larger"] = r["larger with larger grains"] = 1.5
  s["one"] = s["one on stiffer grains"] = s["on the Moon"] = 1; s["larger"] = 2.25; s["larger with larger grains"] = 3.375; s["wider"] = 2
  q["one"] = q["one on stiffer grains"] = q["larger"] = q["larger with larger grains"] = q["wider"] = 1; q["on the Moon"] = 1 / 6
}
/^#/ { finish(); wheel = FILENAME; sub(/.*\/wheel_/, "", wheel); seed = wheel; sub(/__seed.*/, "", wheel); sub(/.*__seed_/, "", seed); sub(/\/.*/, "", seed); gsub(/_/, " ", wheel); named = 0
       if (!(wheel in known)) { known[wheel] = 1; wheels[++many] = wheel }
       if (!(seed in known_seed)) { known_seed[seed] = 1; seeds[++n] = seed }; next }
!named { for (i = 1; i <= NF; ++i) column[$i] = i; named = 1; next }
{ vx[rows] = $column["axle.vx"]; my[rows] = $column["wheel.contact.my"]; wy[rows] = $column["wheel.wy"]; ++rows }
END {
  finish()
  print "| wheel | slip | speed [m/s] | power [W] | samples |\n|---|---|---|---|---|"
  for (k = 1; k <= many; ++k) {
    w = wheels[k]
    for (j = 1; j <= n; ++j) { a[j] = slip[w, seeds[j]]; b[j] = V[w, seeds[j]]; c[j] = P[w, seeds[j]] }
    printf "| %s | %.3f +- %.2g | %.4f +- %.2g | %.3f +- %.2g | %d |\n", w, mean(a, n), half_width(a, n), mean(b, n), half_width(b, n), mean(c, n), half_width(c, n), n
  }
  for (k = 1; k <= many; ++k) {
    w = wheels[k]
    if (w ~ /^one/) continue
    if (!laws++) print "\n| law | asked | found | met |\n|---|---|---|---|"
    for (j = 1; j <= n; ++j) {
      b[j] = V[w, seeds[j]] / (sqrt(q[w] * r[w]) * V["one", seeds[j]]); c[j] = P[w, seeds[j]] / (q[w] * sqrt(q[w] * r[w]) * s[w] * P["one", seeds[j]])
    }
    verdict(w ": speed over that of the law, within 10 %", "0.9 to 1.1", b, n, 0.9, 1.1)
    verdict(w ": power over that of the law, within 10 %", "0.9 to 1.1", c, n, 0.9, 1.1)
  }
  w = "one on stiffer grains"
  if (!(w in known)) exit
  for (j = 1; j <= n; ++j) { b[j] = V[w, seeds[j]] / V["one", seeds[j]]; c[j] = P[w, seeds[j]] / P["one", seeds[j]] }
  print "\n| answer | unit | mean | 95 % interval: +- | samples |\n|---|---|---|---|---|"
  row("speed on stiffer grains over that of wheel one", "", b, n); row("power on stiffer grains over that of wheel one", "", c, n)
}
