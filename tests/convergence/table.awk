# results.csv size.csv size-8000.csv damping.csv -> table.md: what each variant and each size changes, against the scatter between seeds. In
# results.csv every sixth row is a base; the five after each alter one thing (design.yaml).
BEGIN {
  FS = ","
  kinds = split("contacts_per_particle bulk_density_g_per_cm3 core_density_g_per_cm3 repose_angle_deg repose_angle_whole_deg sigma1_at_sigma3_1.25kPa_kPa sigma1_at_sigma3_10kPa_kPa", wanted, " ")
  split("contacts per cluster|bulk density, g/cm3|core density, g/cm3|repose, sloping part, deg|repose, whole, deg|sigma1 at 1.25 kPa, kPa|sigma1 at 10 kPa, kPa", title, "|")
  split("4 elements, 0.1 deg|6 elements, 20 deg|2 elements, 40 deg", material, "|")
  split("half the step|half the loading rate|stiffness number / 3|stiffness number x 3|true masses", variant, "|")
  split("100 200 400 800 1600 8000", size, " ")
}
FNR == 1 { ++file; split("", column); for (i = 1; i <= NF; i++) column[$i] = i; next }
{
  key = file == 1 ? "v" $1 : file == 4 ? "d" $1 : file == 3 ? "s" $1 "-8000" : "s" int(($1 - 1) / 5) + 1 "-" $(column["particles"])
  for (r = 1; r <= kinds; r++) {
    value = wanted[r] in column ? $(column[wanted[r]]) : ""
    if (value == "") continue
    n[key, r]++; sum[key, r] += value; squares[key, r] += value * value
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
function rule(cells,   i) { printf "|"; for (i = 0; i < cells; i++) printf "---|"; print "" }
END {
  print "# What the numerics change"
  print ""
  print "Made by `bash tests/convergence/run.sh` (profile `quick`: 300 clusters, stiffness numbers 300 settling and 1000 in the stress test,"
  print "mass floor 0.4; L_S 1 cm, K 5e4 N/m, eta 0.5 N s/m, rotation xz). ± is a standard error; scatter is the standard deviation between"
  print "seeds; `!` marks a change larger than one seed's scatter and than twice its own standard error."
  for (m = 1; m <= 3; m++) {
    base = "v" (6 * m - 5)
    printf "\n## %s\n\n| quantity | base (%d seeds) | scatter |", material[m], n[base, 1]
    for (v = 1; v in variant; v++) printf " %s |", variant[v]
    print ""; rule(8)
    for (r = 1; r <= kinds; r++) {
      printf "| %s | %.4g | %.2g |", title[r], n[base, r] ? mean(base, r) : 0, deviation(base, r)
      for (v = 1; v in variant; v++) printf " %s |", r <= 5 && v == 2 ? "not felt" : change("v" (6 * m - 5 + v), base, r)
      print ""
    }
    printf "\n| quantity, by clusters |"
    for (i = 1; i in size; i++) printf " %s |", size[i]
    print ""; rule(7)
    for (r = 1; r <= kinds; r++) {
      printf "| %s |", title[r]
      for (i = 1; i in size; i++) {
        key = "s" m "-" size[i]
        if (n[key, r] > 1) printf " %.4g ± %.2g |", mean(key, r), deviation(key, r) / sqrt(n[key, r])
        else if (n[key, r]) printf " %.4g (1 seed) |", mean(key, r)
        else printf " not measured |"
        if (n[key, r]) printf "%s %s %.6g %.3g\n", m, size[i], mean(key, r), deviation(key, r) / sqrt(n[key, r]) > (plots "-" r ".dat")
      }
      print ""
    }
  }
  print "\n## Overdamped contacts counted as critically damped (150 clusters, L_S 0.5 cm, true masses, eta 1 N s/m)\n"
  print "| quantity | 6 elements, 0.1 deg | scatter | with most_damping_ratio 1 | 2 elements, 40 deg | scatter | with most_damping_ratio 1 |"
  rule(7)
  for (r = 1; r <= kinds; r++) {
    if (!n["d1", r] || !n["d3", r]) continue
    printf "| %s | %.4g | %.2g | %s | %.4g | %.2g | %s |\n", title[r], mean("d1", r), deviation("d1", r), change("d2", "d1", r), \
      mean("d3", r), deviation("d3", r), change("d4", "d3", r)
  }
}
