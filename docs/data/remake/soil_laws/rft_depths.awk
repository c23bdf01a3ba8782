# histories of `footfall rig rft`, one after another -> zeta and R^2 from several ranges of the depth, and alpha_x and alpha_z of the two ranges by gamma.
# A plate that comes out (gamma < 0) was pushed down first: inputs/laws/rft_out.toml.
# Samples of a pair are taken together.
# -v points=FILE: beta gamma alpha_x alpha_z of every pair there, from one to three widths [deg, deg, N/cm^3, N/cm^3].
# As mbd_solver/cli/rigs/rft_rig.cpp does it: slopes through zero at the mean surface over the depth of the plate's middle, one width being 0.05 m.
function alpha_z(b, g) { return 0.206 + 0.169 * cos(2 * b) + 0.212 * sin(2 * b + g) + 0.358 * sin(g) + 0.055 * sin(-2 * b + g) }
function alpha_x(b, g) { return -0.124 * cos(2 * b + g) + 0.253 * cos(g) + 0.007 * cos(-2 * b + g) + 0.088 * sin(2 * b) }
function fit(from, to,   p, tt, tm, mean, n, s, v, z, k, w) {   # ranges from..to of one width each, together; zeta and R^2
  for (p = 1; p <= pairs; ++p) {
    w = 0; k = 0; z = 0
    for (n = from; n <= to; ++n) { w += dd[p, n]; k += dx[p, n]; z += dz[p, n] }
    found[p, "x"] = k / w / 1e6; found[p, "z"] = z / w / 1e6
  }
  n = 2 * pairs; tt = 0; tm = 0; mean = 0; s = 0; v = 0
  for (p = 1; p <= pairs; ++p) for (k in both) { tt += theory[p, k]^2; tm += theory[p, k] * found[p, k]; mean += found[p, k] / n }
  zeta = tm / tt
  for (p = 1; p <= pairs; ++p) for (k in both) { s += (found[p, k] - zeta * theory[p, k])^2; v += (found[p, k] - mean)^2 }
  return 1 - s / v
}
BEGIN { FS = ","; pi = 3.14159265358979; width = 0.05; surface = -0.008; area = width^2; both["x"]; both["z"] }
/^#/ { name = FILENAME; sub(/.*angles_/, "", name); sub(/__seed.*/, "", name); split(name, angle, "_"); named = 0
       if (!(name in pair_of)) pair_of[name] = ++pairs
       pair = pair_of[name]; gamma[pair] = angle[2]; beta[pair] = angle[1]
       theory[pair, "x"] = alpha_x(angle[1] * pi / 180, angle[2] * pi / 180); theory[pair, "z"] = alpha_z(angle[1] * pi / 180, angle[2] * pi / 180); next }
!named { for (i = 1; i <= NF; ++i) column[$i] = i; named = 1; next }
{ depth = surface - $column["plate.z"]; range = int(depth / width)
  if (depth < width) next
  if (gamma[pair] < 0 && ($column["plate.vz"] <= 0 || range > 2)) next   # still on its way down, to where it is drawn out from
  dd[pair, range] += depth^2; dx[pair, range] -= depth * $column["plate.contact.fx"] / area; dz[pair, range] += depth * $column["plate.contact.fz"] / area }
END {
  print "| depths [plate widths] | zeta | R^2 |\n|---|---|---|"
  r = fit(1, 3); printf "| 1 to 3 | %.3f | %.4f |\n", zeta, r
  if (points) for (p = 1; p <= pairs; ++p) print beta[p], gamma[p], found[p, "x"], found[p, "z"] > points
  r = fit(1, 1); printf "| 1 to 2 | %.3f | %.4f |\n", zeta, r
  for (p = 1; p <= pairs; ++p) for (k in both) upper[p, k] = found[p, k]
  r = fit(2, 3); printf "| 2 to 3 | %.3f | %.4f |\n", zeta, r
  print "\n| gamma [deg] | alpha_x of 1 to 2 widths | of 2 to 3 | alpha_z of 1 to 2 widths | of 2 to 3 |\n|---|---|---|---|---|"
  for (g = -90; g <= 90; g += 20) {
    n = 0; delete sum
    for (p = 1; p <= pairs; ++p) if (gamma[p] == g) { ++n; for (k in both) { sum[k, 1] += upper[p, k]; sum[k, 2] += found[p, k] } }
    if (n) printf "| %d | %.3f | %.3f | %.3f | %.3f |\n", g, sum["x", 1] / n, sum["x", 2] / n, sum["z", 1] / n, sum["z", 2] / n
  }
}
