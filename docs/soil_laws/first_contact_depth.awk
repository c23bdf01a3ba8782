# Histories of inputs/laws/first_contact_others.toml -> what each change does to the force at one depth, 15 to 35 mm, and to F / (v / v0)^1.506, v the speed there and 1.506 the exponent
# that first_contact.toml found. Means over the depth, then over the samples.
BEGIN { FS = "," }
FNR == 1 { close_file(); file = FILENAME; sub(/.*runs\//, "", file); sub(/__seed.*/, "", file); v0 = z0 = ""; n = force = of_speed = 0 }
/^time/ { for (i = 1; i <= NF; ++i) column[$i] = i }
$1 + 0 == $1 {
  v = $column["ball.vz"]; z = $column["ball.z"]; F = $column["ball.contact.fz"]
  if (v0 == "") { v0 = v; z0 = z }
  if (z0 - z >= 0.015 && z0 - z <= 0.035) { ++n; force += F; of_speed += F / (v / v0)^1.506 }
}
END {
  close_file()
  print "| speed | change | force between 15 and 35 mm, ratio | the same of the speed there |\n|---|---|---|---|"
  for (k = 1; k <= cases; ++k) {
    none = order[k]; sub(/change_.*/, "change_none", none)
    if (order[k] == none) continue
    speed = order[k]; sub(/__.*/, "", speed); sub(/speed_/, "", speed)
    change = order[k]; sub(/.*change_/, "", change); gsub(/_/, " ", change)
    printf "| %s m/s | %s | %.2f | %.2f |\n", speed, change, F_mean[order[k]] / F_mean[none], V_mean[order[k]] / V_mean[none]
  }
}
function close_file() {
  if (file == "" || n == 0) return
  if (!(file in F_mean)) order[++cases] = file
  F_mean[file] += force / n; V_mean[file] += of_speed / n
}
