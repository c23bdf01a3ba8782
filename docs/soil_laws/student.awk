# Mean of v[1..n], and the half width of its 95 % interval by Student's t.
function mean(v, n,   k, m) { for (k = 1; k <= n; ++k) m += v[k] / n; return m }
function half_width(v, n,   k, m, s, student) {
  if (n < 2) return 0
  split("0 12.706 4.303 3.182 2.776 2.571 2.447 2.365 2.306 2.262", student, " ")
  m = mean(v, n)
  for (k = 1; k <= n; ++k) s += (v[k] - m)^2
  return student[n] * sqrt(s / (n - 1) / n)
}
function row(name, unit, v, n) {
  printf "| %s | %s | %.4g | %s | %d |\n", name, unit, mean(v, n), (n > 1 ? sprintf("%.2g", half_width(v, n)) : ""), n
}
# Whether the mean lies in [least, most], and whether the interval leaves it open.
function verdict(text, asked, v, n, least, most,   m, h, in_it) {
  m = mean(v, n); h = half_width(v, n)
  in_it = m >= least && m <= most
  printf "| %s | %s | %.4g%s | %s |\n", text, asked, m, (n > 1 ? sprintf(" +- %.2g", h) : ""), (in_it ? "yes" : "no") (m - h < least && m + h >= least || m + h > most && m - h <= most ? ", but the interval leaves it open" : "")
}
