# runs.csv of inputs/laws/janssen.toml, or of its like with grains of `radius` [m] -> tables, and the points of the picture into the file `points`.
# W = W_s (1 - exp(-W_0 / W_s)): W_s by least squares, a golden section between 1e-3 and 1e3 N. K = rho g A^2 / (perimeter mu_w W_s).
function floor_of(W0, Ws) { return Ws * (1 - exp(-W0 / Ws)) }
function misfit(seed, Ws,   k, s) { for (k = 1; k <= many[seed]; ++k) s += (W[seed, k] - floor_of(W0[seed, k], Ws))^2; return s }
function fitted(seed,   a, b, c, d, k) {
  a = log(1e-3); b = log(1e3)
  for (k = 0; k < 100; ++k) { c = b - 0.618034 * (b - a); d = a + 0.618034 * (b - a)
    if (misfit(seed, exp(c)) < misfit(seed, exp(d))) b = d; else a = c }
  return exp((a + b) / 2)
}
# R^2 of the form with W_s.
function quality(seed, Ws,   k, average, total) {
  for (k = 1; k <= many[seed]; ++k) average += W[seed, k] / many[seed]
  for (k = 1; k <= many[seed]; ++k) total += (W[seed, k] - average)^2
  return 1 - misfit(seed, Ws) / total
}
BEGIN { FS = ","; g = 9.81; grain = 2600 * 4 / 3 * 3.14159265 * radius^3 * g; width = 0.08; mu = 0.5; bulk = 0.57 * 2600 }
NR == 1 { next }
$4 != "done" { print "run " $1 ": " $4 > "/dev/stderr"; exit 1 }
{ floor = -$5; weight = $6 * grain; share[$2, ++count[$2]] = floor / weight; weights[$2] += weight
  if (!($2 in known)) { known[$2] = 1; fills[++n_fills] = $2 }
  if ($2 ~ /smooth/) { smooth[++n_smooth] = floor / weight; next }
  if (!($3 in many)) seeds[++n_seeds] = $3
  k = ++many[$3]; W0[$3, k] = weight; W[$3, k] = floor }
END {
  print "| column filled to [m] | weight of the grains [N] | share on the floor | 95 % interval: +- | samples |\n|---|---|---|---|---|"
  for (f = 1; f <= n_fills; ++f) {
    n = count[fills[f]]
    for (k = 1; k <= n; ++k) r[k] = share[fills[f], k]
    printf "| %s | %.3g | %.3f | %.2g | %d |\n", fills[f], weights[fills[f]] / n, mean(r, n), half_width(r, n), n
  }
  for (i = 1; i <= n_seeds; ++i) {
    seed = seeds[i]; Ws[i] = fitted(seed); K[i] = bulk * g * width^3 / 4 / mu / Ws[i]
    for (k = 1; k <= many[seed]; ++k) print W0[seed, k], W[seed, k] > points
    R2[i] = quality(seed, Ws[i])
  }
  # The fit to the means over the samples, under the name "means".
  for (f = 1; f <= n_fills; ++f) {
    if (fills[f] ~ /smooth/) continue
    n = count[fills[f]]; k = ++many["means"]; W0["means", k] = weights[fills[f]] / n
    for (i = 1; i <= n; ++i) r[i] = share[fills[f], i]
    W["means", k] = mean(r, n) * W0["means", k]
  }
  of_means[1] = quality("means", fitted("means"))
  print mean(Ws, n_seeds) > (points ".ws")
  print "\n| answer | unit | mean | 95 % interval: +- | samples |\n|---|---|---|---|---|"
  row("W_s", "N", Ws, n_seeds); row("K", "", K, n_seeds)
  print "\n| law | asked | found | met |\n|---|---|---|---|"
  verdict("the weight on the floor saturates as Janssen's form with one number: R^2 at least 0.95", "0.95 to 1", R2, n_seeds, 0.95, 1)
  verdict("the same of the means over the samples", "0.95 to 1", of_means, 1, 0.95, 1)
  verdict("K lies between that of a soil about to give way, (1 - sin phi) / (1 + sin phi) at 27 degrees, and 1", "0.37 to 1", K, n_seeds, 0.37, 1)
  if (n_smooth) verdict("with smooth walls the floor carries all, within 1 %", "0.99 to 1.01", smooth, n_smooth, 0.99, 1.01)
}
