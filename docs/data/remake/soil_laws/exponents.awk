# fits.csv of an experiment -> what a law asks of exponents, as rows of a table of laws. A sum of exponents is told as independent errors would have it.
#   asks: ASK;ASK...  ASK: FIT/EXPONENT=ASKED/TEXT, or FIT/EXPONENT+FACTOR*EXPONENT=ASKED/TEXT
BEGIN { FS = "," }
NR > 1 && $2 == "fitted" && $5 != "nan" { value[$1, $3] = $4; error[$1, $3] = $5; t[$1] = ($7 - $4) / $5 }
END {
  print "| law | asked | found | met |\n|---|---|---|---|"
  n = split(asks, ask, ";")
  for (i = 1; i <= n; ++i) {
    split(ask[i], part, "/"); split(part[2], side, "=")
    fit = part[1]; terms = split(side[1], term, "+"); sum = 0; variance = 0
    for (k = 1; k <= terms; ++k) {
      f = 1; name = term[k]
      if (split(name, factor, "*") == 2) { f = factor[1]; name = factor[2] }
      sum += f * value[fit, name]; variance += (f * error[fit, name])^2
    }
    half = sqrt(variance) * (t[fit] < 0 ? -t[fit] : t[fit])
    text = ask[i]; sub(/^[^\/]*\/[^\/]*\//, "", text)
    printf "| %s | %s | %.2f +- %.2f | %s |\n", text, side[2], sum, half, (sum - half <= side[2] && side[2] <= sum + half) ? "yes" : "no"
  }
}
