# Histories of inputs/laws/pad_stiffness.toml -> the exponent of depth beyond the first 10 mm over the speed that is left there, for each modulus: a straight line through logarithms.
# Depths are below the highest grain, from the height at the start, 1 mm above it.
BEGIN { FS = "," }
FNR == 1 { close_file(); modulus = FILENAME; sub(/.*modulus_/, "", modulus); sub(/__.*/, "", modulus); top = ""; left = deepest = 0 }
/^time/ { for (i = 1; i <= NF; ++i) column[$i] = i }
$1 + 0 == $1 {
  if (top == "") top = $column["pad.z"] - 1e-3
  z = top - $column["pad.z"]
  if (z >= 0.01 && !left) left = -$column["pad.vz"]
  if (z > deepest) deepest = z
}
END {
  close_file()
  print "| modulus [MPa] | depth beyond 10 mm goes as the speed left there to the power of |\n|---|---|"
  for (m in n) printf "| %g | %.2f |\n", m / 1e6, (XY[m] - X[m] * Y[m] / n[m]) / (XX[m] - X[m] * X[m] / n[m]) | "sort -t \"|\" -k 2n"
}
function close_file(   x, y) {
  if (modulus == "" || !left) return
  x = log(left); y = log(deepest - 0.01)
  ++n[modulus]; X[modulus] += x; Y[modulus] += y; XX[modulus] += x * x; XY[modulus] += x * y
}
