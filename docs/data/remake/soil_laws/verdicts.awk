# Texts and tables of the page's sections, one after another in the order of the page -> all verdicts in one table, each with a link to its section.
/^##+ / {
  section = $0; sub(/^#+ /, "", section)
  anchor = tolower(section); gsub(/[^a-z0-9 -]/, "", anchor); gsub(/ /, "-", anchor)
  next
}
/^[|] law [|] asked [|]/ { table = "law"; next }
/^[|] statement [|] numbers [|]/ { table = "statement"; next }
!/^[|]/ { table = ""; next }
/^[|]--/ || table == "" { next }
{
  split($0, cell, /[ ]*[|][ ]*/)
  if (table == "law") { asked = cell[3]; found = cell[4] } else { asked = cell[4]; found = cell[3] }
  met = cell[5]
  row[++rows] = "| [" section "](#" anchor ") | " cell[2] " | " asked " | " found " | " met " |"
  ++count[met ~ /leaves it open/ ? "open" : met ~ /^yes/ ? "yes" : "no"]
}
END {
  print "## Verdicts\n"
  printf "%d statements: %d met, %d not met, and %d with intervals that leave them open. What a rig measures without a law is told below.\n\n", rows, count["yes"], count["no"], count["open"]
  print "| section | law | asked | found | met |\n|---|---|---|---|---|"
  for (i = 1; i <= rows; ++i) print row[i]
}
