# results.csv -> table.md: seed scatter of the base settings, and what each variant changes. Rows 1, 5, 9 are the bases; the three
# after each are half the step, half the loading rate, twice the clusters (design.yaml).
BEGIN {
  FS = ","
  split("contacts_per_particle bulk_density_g_per_cm3 core_density_g_per_cm3 repose_angle_deg repose_angle_whole_deg sigma1_at_sigma3_1.25kPa_kPa sigma1_at_sigma3_10kPa_kPa", wanted, " ")
  split("contacts per cluster|bulk density, g/cm3|core density, g/cm3|repose, sloping part, deg|repose, whole, deg|sigma1 at 1.25 kPa, kPa|sigma1 at 10 kPa, kPa", title, "|")
  split("4 elements, 0.1 deg|6 elements, 20 deg|2 elements, 40 deg", material, "|")
}
NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
{
  for (r in wanted) {
    value = $(column[wanted[r]])
    if (value == "") continue
    n[$1, r]++; sum[$1, r] += value; squares[$1, r] += value * value
  }
}
function mean(p, r) { return sum[p, r] / n[p, r] }
function deviation(p, r,   m, v) {
  if (n[p, r] < 2) return 0
  m = mean(p, r); v = (squares[p, r] - n[p, r] * m * m) / (n[p, r] - 1)
  return v > 0 ? sqrt(v) : 0
}
function change(p, base, r,   d, e) {
  if (!n[p, r] || !n[base, r]) return "not measured"
  d = mean(p, r) - mean(base, r)
  e = sqrt(deviation(p, r) ^ 2 / n[p, r] + deviation(base, r) ^ 2 / n[base, r])
  return sprintf("%+.3g ± %.2g%s", d, e, (d < 0 ? -d : d) > 2 * e && (d < 0 ? -d : d) > deviation(base, r) ? " !" : "")
}
END {
  print "# What the numerics change"
  print ""
  print "Made by `bash tests/convergence/run.sh` (profile `quick`, 300 clusters, L_S 1 cm, K 5e4 N/m, eta 0.5 N s/m, rotation xz, 6 seeds)."
  print "Scatter = standard deviation between seeds. Changes are variant less base, ± their standard error; `!` marks a change larger than"
  print "the scatter of one seed and than twice its own standard error."
  for (m = 1; m <= 3; m++) {
    base = 4 * m - 3
    print ""
    print "## " material[m]
    print ""
    print "| quantity | base | scatter | half the step | half the loading rate | twice the clusters |"
    print "|---|---|---|---|---|---|"
    for (r = 1; r in title; r++) {
      if (!n[base, r]) { print "| " title[r] " | not measured | | | | |"; continue }
      printf "| %s | %.4g (%d seeds) | %.2g | %s | %s | %s |\n", title[r], mean(base, r), n[base, r], deviation(base, r), \
        change(base + 1, base, r), r <= 5 ? "not felt" : change(base + 2, base, r), change(base + 3, base, r)
    }
  }
}
