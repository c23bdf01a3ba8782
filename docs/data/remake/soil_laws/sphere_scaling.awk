# sphere_samples.csv of `footfall rig sphere`, one folder DIAMETER_DENSITY for each sphere -> d1 and k of each, and their exponents of diameter and density by least squares over all samples:
#   log y = c + a log(D / D0) + b log(rho / rho0), without b where all spheres have one density.
function solve(a, y, x,   i, j, k, f) {          # a x = y of `unknowns`, a symmetric and positive
  for (i = 1; i <= unknowns; ++i) for (k = i + 1; k <= unknowns; ++k) { f = a[k, i] / a[i, i]; for (j = i; j <= unknowns; ++j) a[k, j] -= f * a[i, j]; y[k] -= f * y[i] }
  for (i = unknowns; i >= 1; --i) { x[i] = y[i]; for (j = i + 1; j <= unknowns; ++j) x[i] -= a[i, j] * x[j]; x[i] /= a[i, i] }
}
# Exponent[2] of D and [3] of rho of value[1..n], and the half widths of their 95 % intervals.
function fit(value, exponent, half,   i, j, k, r, s, a, y, x, unit, column) {
  for (column = 0; column <= unknowns; ++column) {   # 0: the fit; from 1 on: a column of the inverse of the normal matrix
    for (i = 1; i <= unknowns; ++i) { y[i] = (column == i); for (j = 1; j <= unknowns; ++j) a[i, j] = 0 }
    for (k = 1; k <= n; ++k) { r[1] = 1; r[2] = D[k]; r[3] = rho[k]; for (i = 1; i <= unknowns; ++i) { if (!column) y[i] += r[i] * log(value[k]); for (j = 1; j <= unknowns; ++j) a[i, j] += r[i] * r[j] } }
    solve(a, y, x)
    if (column) half[column] = x[column]
    else for (i = 1; i <= unknowns; ++i) exponent[i] = x[i]
  }
  for (k = 1; k <= n; ++k) s += (log(value[k]) - exponent[1] - exponent[2] * D[k] - (unknowns > 2 ? exponent[3] * rho[k] : 0))^2
  for (i = 1; i <= unknowns; ++i) half[i] = student(n - unknowns) * sqrt(s / (n - unknowns) * half[i])
}
function claim(text, asked, found, half) {
  printf "| %s | %.3g | %.2f +- %.2f | %s |\n", text, asked, found, half, (found - half <= asked && asked <= found + half ? "yes" : "no")
}
function of_sphere(v, sphere,   k) { m = 0; for (k = 1; k <= n; ++k) if (of[k] == sphere) one[++m] = v[k]; return sprintf("%.3g +- %.2g", mean(one, m), half_width(one, m)) }
BEGIN { FS = "," }
FNR == 1 { name = FILENAME; sub(/\/sphere_samples.csv$/, "", name); sub(/.*\//, "", name); split(name, part, "_"); spheres[++many] = name; if (!(part[2] in densities)) { densities[part[2]]; ++n_densities } for (i = 1; i <= NF; ++i) column[$i] = i; next }
$1 == "none" {
  ++n; of[n] = name; D[n] = log(part[1] / 0.12); rho[n] = log(part[2] / 2800)
  d1_D[n] = $column["d1 / D"]; kD[n] = $column["k D / (m g)"]; both[n] = $column["k d1 over its law"]; R2[n] = $column["R^2"]
  d1[n] = d1_D[n] * part[1]; k_mg[n] = kD[n] / part[1]
}
END {
  unknowns = n_densities > 1 ? 3 : 2
  print "| diameter [m] | density [kg/m3] | d1 / D | k D / (m g) | R^2 | k d1 / (m g) sqrt(rho_b / rho_s) | samples |\n|---|---|---|---|---|---|---|"
  for (i = 1; i <= many; ++i) {
    split(spheres[i], part, "_"); a = of_sphere(d1_D, spheres[i]); b = of_sphere(kD, spheres[i]); c = of_sphere(R2, spheres[i]); d = of_sphere(both, spheres[i])
    printf "| %s | %s | %s | %s | %s | %s | %d |\n", part[1], part[2], a, b, c, d, m
  }
  print "\n| law | asked | found | met |\n|---|---|---|---|"
  fit(d1, e, h); claim(label "d1 goes as the diameter of the sphere", 1, e[2], h[2]); if (unknowns > 2) claim("d1 goes as the density of the sphere", 1, e[3], h[3])
  fit(k_mg, e, h); claim(label "k / (m g) goes as 1 / diameter", -1, e[2], h[2]); if (unknowns > 2) claim("k / (m g) goes as the density to the power of -1/2", -0.5, e[3], h[3])
}
