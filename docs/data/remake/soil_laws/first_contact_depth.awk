# fits.csv of first_contact.toml, then histories of first_contact_others.toml -> where the peak comes, and what each change does to the force at one depth, 15 to 35 mm, and to
# F / (v / v0)^n, v the speed there and n the exponent of v that first_contact.toml found. Means over the depth, then over the samples.
BEGIN { FS = "," }
FILENAME ~ /fits.csv$/ { if ($2 == "fitted" && $3 == "v") exponent = $4; next }
FNR == 1 { close_file(); file = FILENAME; sub(/.*runs\//, "", file); sub(/__seed.*/, "", file); v0 = z0 = ""; n = force = of_speed = peak = 0 }
/^time/ { for (i = 1; i <= NF; ++i) column[$i] = i }
$1 + 0 == $1 {
  v = $column["ball.vz"]; z = $column["ball.z"]; F = $column["ball.contact.fz"]
  if (v0 == "") { v0 = v; z0 = z }
  if (F > peak) { peak = F; peak_depth = z0 - z; peak_speed = v / v0 }
  if (z0 - z >= 0.015 && z0 - z <= 0.035) { ++n; force += F; of_speed += F / (v / v0)^exponent }
}
END {
  close_file()
  print "| speed | change | peak at a depth of [mm] | with a share of the speed of | force between 15 and 35 mm, ratio | the same of the speed there |\n|---|---|---|---|---|---|"
  for (k = 1; k <= cases; ++k) {
    none = order[k]; sub(/change_.*/, "change_none", none)
    speed = order[k]; sub(/__.*/, "", speed); sub(/speed_/, "", speed)
    change = order[k]; sub(/.*change_/, "", change); gsub(/_/, " ", change)
    printf "| %s m/s | %s | %.0f | %.2f | %.2f | %.2f |\n", speed, change, 1e3 * depth[order[k]] / samples[order[k]], kept[order[k]] / samples[order[k]], F_mean[order[k]] / F_mean[none], V_mean[order[k]] / V_mean[none]
  }
}
function close_file() {
  if (file == "" || n == 0) return
  if (!(file in F_mean)) order[++cases] = file
  ++samples[file]; depth[file] += peak_depth; kept[file] += peak_speed
  F_mean[file] += force / n; V_mean[file] += of_speed / n
}
