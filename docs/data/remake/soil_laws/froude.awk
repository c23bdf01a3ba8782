# runs.csv of inputs/laws/froude.toml -> depth over length, and peak force over density * gravity * length^3, of both scales.
BEGIN { FS = ","; length_of["other"] = 2; force_of["other"] = 0.8 * 1.62 / 9.81 * 8; length_of["one"] = force_of["one"] = 1 }
NR == 1 { next }
$4 != "done" { print "run " $1 ": " $4 > "/dev/stderr"; exit 1 }
{ n = ++count[$2]; depth[$2, n] = $5 / length_of[$2]; force[$2, n] = $6 / force_of[$2] }
function told(v, name, unit,   k, a, b, ea, eb, ma, mb) {
  for (k = 1; k <= n; ++k) { a[k] = v["one", k]; b[k] = v["other", k] }
  ma = mean(a, n); mb = mean(b, n); ea = standard_error(a, n); eb = standard_error(b, n)
  rows = rows sprintf("| %s | %.4g +- %.2g | %.4g +- %.2g | %d |\n", name " " unit, ma, ea, mb, eb, n)
  claims = claims sprintf("| %s: means agree within their standard errors | at most 1 | difference over the sum of the standard errors %.2f | %s |\n", name, (ma > mb ? ma - mb : mb - ma) / (ea + eb), ((ma > mb ? ma - mb : mb - ma) <= ea + eb ? "yes" : "no"))
}
END {
  told(depth, "depth", "[m]"); told(force, "peak force", "[N]")
  print "| in the units of the first | one | other | samples |\n|---|---|---|---|\n" rows
  print "+- is the standard error of the mean.\n"
  print "| law | asked | found | met |\n|---|---|---|---|\n" claims
}
