# histories of inputs/laws/pad_drops.toml, one after another -> stress on the pad as k z + c v^2, and the depths that these two numbers foretell.
# z: depth of the pad's face below the highest grain, from its height at the start, 1 mm above it. Fitted to all rows in which the pad goes down, from z = 9 mm (a radius) on.
# Then the depth beyond the first blow, which takes the first 10 mm: how it goes with the speed that is left there, in runs with at least a fifth of it.
# The foretold depth is where v^2 from d(v^2)/dz = 2 g - 2 A (k z + c v^2) / m becomes zero.
function depth_of(m, v, A,   u, z, dz, k1, k2) {
  u = v * v; z = 0; dz = 1e-5
  while (u > 0 && z < 1) {
    k1 = 2 * g - 2 * A * (k * z + c * u) / m
    k2 = 2 * g - 2 * A * (k * (z + dz) + c * (u + dz * k1)) / m
    u += dz * (k1 + k2) / 2; z += dz
  }
  return z
}
# Exponents of depth ~ m^a v^b A^c by least squares on logarithms: values[run, 0 ... 3] are log m, log v, log A, log depth.
function exponents(values, runs, answer,   i, j, l, n, mean, s, f) {
  for (j = 0; j < 4; ++j) { mean[j] = 0; for (i = 1; i <= runs; ++i) mean[j] += values[i, j] / runs }
  for (j = 0; j < 3; ++j) for (l = 0; l < 4; ++l) { s[j, l] = 0; for (i = 1; i <= runs; ++i) s[j, l] += (values[i, j] - mean[j]) * (values[i, l] - mean[l]) }
  for (j = 0; j < 3; ++j) for (i = j + 1; i < 3; ++i) { f = s[i, j] / s[j, j]; for (l = j; l < 4; ++l) s[i, l] -= f * s[j, l] }
  for (j = 2; j >= 0; --j) { answer[j] = s[j, 3]; for (l = j + 1; l < 3; ++l) answer[j] -= s[j, l] * answer[l]; answer[j] /= s[j, j] }
}
BEGIN { FS = ","; g = 9.81; kBlow = 0.01 }
/^#/ {
  name = FILENAME; sub(/.*mass_/, "", name); sub(/__seed.*/, "", name); split(name, part, /__[a-z]+_/); ++runs; named = 0; begun = 0
  mass[runs] = part[1]; speed[runs] = part[2]; area[runs] = part[3]; deepest[runs] = left_speed[runs] = 0
  next
}
!named { for (i = 1; i <= NF; ++i) column[$i] = i; named = 1; next }
!begun { top = $column["pad.z"] - 1e-3; begun = 1 }
{
  z = top - $column["pad.z"]; w = $column["pad.vz"]^2; p = $column["pad.contact.fz"] / area[runs]
  if (z > deepest[runs]) deepest[runs] = z
  if (z >= kBlow && !left_speed[runs]) left_speed[runs] = sqrt(w)
  if (z < 0.009 || $column["pad.vz"] >= 0) next
  zz += z * z; zw += z * w; ww += w * w; zp += z * p; wp += w * p; sum += p; pp += p * p; ++rows
}
END {
  k = (zp * ww - wp * zw) / (zz * ww - zw * zw); c = (wp * zz - zp * zw) / (zz * ww - zw * zw)
  left = pp - k * zp - c * wp
  for (i = 1; i <= runs; ++i) {
    found[i, 0] = foretold[i, 0] = log(mass[i]); found[i, 1] = foretold[i, 1] = log(speed[i]); found[i, 2] = foretold[i, 2] = log(area[i])
    found[i, 3] = log(deepest[i]); foretold[i, 3] = log(depth_of(mass[i], speed[i], area[i]))
    off += (found[i, 3] - foretold[i, 3])^2; shift += (foretold[i, 3] - found[i, 3]) / runs
  }
  exponents(found, runs, a); exponents(foretold, runs, b)
  printf "stress = k z + c v^2 with k = %.3g Pa/m and c = %.0f kg/m^3: %d rows of all %d runs, R^2 = %.3f.\n\n", k, c, rows, runs, 1 - left / (pp - sum * sum / rows)
  print "| exponent of | found | foretold by these two numbers |\n|---|---|---|"
  printf "| m | %.2f | %.2f |\n| v | %.2f | %.2f |\n| A | %.2f | %.2f |\n\n", a[0], b[0], a[1], b[1], a[2], b[2]
  printf "Foretold depths are off by %.0f %% (root of the mean square; in the mean %+.0f %%).\n", 100 * sqrt(off / runs), 100 * shift

  for (i = 1; i <= runs; ++i) {
    if (left_speed[i] < 0.2 * speed[i]) continue
    ++going; share[i] = left_speed[i] / speed[i]
    beyond[going, 0] = log(mass[i]); beyond[going, 1] = log(left_speed[i]); beyond[going, 2] = log(area[i]); beyond[going, 3] = log(deepest[i] - kBlow)
    x = log(mass[i] * left_speed[i]^2 / area[i]); y = beyond[going, 3]
    X += x; Y += y; XX += x * x; XY += x * y; YY += y * y
    if (!least || share[i] < least) least = share[i]
    if (share[i] > most) most = share[i]
  }
  exponents(beyond, going, e)
  sxx = XX - X * X / going; sxy = XY - X * Y / going; syy = YY - Y * Y / going; slope = sxy / sxx
  printf "\nBeyond the first 10 mm, in the %d runs that have a fifth of their speed v1 left there (%.2f to %.2f of it):\n\n", going, least, most
  print "| depth beyond 10 mm goes with | exponent | p0 bears | k z bears |\n|---|---|---|---|"
  printf "| m | %.2f | 1 | 0.5 |\n| v1 | %.2f | 2 | 1 |\n| A | %.2f | -1 | -0.5 |\n", e[0], e[1], e[2]
  printf "| m v1^2 / A, alone (R^2 = %.3f) | %.2f +- %.2f (standard error) | 1 | 0.5 |\n", sxy * sxy / (sxx * syy), slope, sqrt((syy / sxx - slope * slope) / (going - 2))
}
