# Mean of v[1..n], and the half width of its 95 % interval by Student's t.
function mean(v, n,   k, m) { for (k = 1; k <= n; ++k) m += v[k] / n; return m }
function half_width(v, n) { return n < 2 ? 0 : student(n - 1) * standard_error(v, n) }
function standard_error(v, n,   k, m, s) {
  m = mean(v, n)
  for (k = 1; k <= n; ++k) s += (v[k] - m)^2
  return sqrt(s / (n - 1) / n)
}
# Student's t of a two-sided 95 % interval with f degrees of freedom; beyond 20 that of 20, which is larger.
function student(f,   t) {
  split("12.706 4.303 3.182 2.776 2.571 2.447 2.365 2.306 2.262 2.228 2.201 2.179 2.160 2.145 2.131 2.120 2.110 2.101 2.093 2.086", t, " ")
  return t[f > 20 ? 20 : f]
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
