# histories of inputs/laws/footpad.toml, one after another -> mean pressure of the plate at some sinkages. Sinkage counts from the mean surface, a grain's radius below z = 0.
function finish(   i) {
  if (soil == "") return
  for (i = 1; i <= 3; ++i) pressure[soil, i, samples[soil] + 1] = n[i] ? sum[i] / n[i] / 1000 : 0
  over[soil, samples[soil] + 1] = n[4] ? sum[4] / n[4] / 1000 : 0
  ++samples[soil]; delete n; delete sum
}
BEGIN { FS = ","; at[1] = 0.02; at[2] = 0.035; at[3] = 0.05; near = 0.002; radius = 0.0125; area = 0.25^2 }
/^#/ { finish(); soil = FILENAME; sub(/.*\/soil_/, "", soil); sub(/__seed.*/, "", soil); gsub(/_/, " ", soil); named = 0
       if (!(soil in samples)) { samples[soil] = 0; soils[++many] = soil }; next }
!named { for (i = 1; i <= NF; ++i) column[$i] = i; named = 1; next }
{ s = -radius - ($column["plate.z"] - 0.01); p = $column["plate.contact.fz"] / area
  for (i = 1; i <= 3; ++i) if (s >= at[i] - near && s <= at[i] + near) { sum[i] += p; ++n[i] }
  if (s >= 0.02 && s <= 0.05) { sum[4] += p; ++n[4] } }
END {
  finish()
  print "| soil | pressure at 20 mm [kPa] | at 35 mm | at 50 mm | samples |\n|---|---|---|---|---|"
  for (k = 1; k <= many; ++k) {
    printf "| %s ", soils[k]
    for (i = 1; i <= 3; ++i) {
      for (j = 1; j <= samples[soils[k]]; ++j) v[j] = pressure[soils[k], i, j]
      printf "| %.3g%s ", mean(v, samples[soils[k]]), (samples[soils[k]] > 1 ? sprintf(" +- %.2g", half_width(v, samples[soils[k]])) : "")
    }
    print "| " samples[soils[k]] " |"
  }
  print "\n| law | asked | found [kPa] | met |\n|---|---|---|---|"
  for (k = 1; k <= many; ++k) {
    for (j = 1; j <= samples[soils[k]]; ++j) v[j] = over[soils[k], j]
    verdict(soils[k] ": mean pressure from 20 to 50 mm of sinkage as under Surveyor's footpads", "20 to 60", v, samples[soils[k]], 20, 60)
  }
}
