# build/bench/peers.csv -> the table of peers.sh. Medians over rounds, with the least and the most in brackets.
BEGIN {
  FS = ","
  split("A B C D1 A_fall", order, " ")
  title["A"] = "A       1000 x 6 settled"; clusters["A"] = 1000; spheres["A"] = 6000
  title["B"] = "B       1000 x 2 settled"; clusters["B"] = 1000; spheres["B"] = 2000
  title["C"] = "C       8000 x 6 settled"; clusters["C"] = 8000; spheres["C"] = 48000
  title["D1"] = "D1      1000 x 1 settled"; clusters["D1"] = 1000; spheres["D1"] = 1000
  title["A_fall"] = "A_fall  1000 x 6 falling"; clusters["A_fall"] = 1000; spheres["A_fall"] = 6000
}
NR == 1 { next }
$2 == "peak" { if ($7 > peak) peak = $7; next }  # GFLOP/s
{
  run = $2 SUBSEP $3 SUBSEP $4
  n[run]++
  cpu[run, n[run]] = $7; wall[run, n[run]] = $6
  contacts[run] = $8; walls[run] = $9; kinetic[run] = $10; steps[$2] = $5
}
# Sorts values[key, 1..count] into sorted[1..count].
function sort(values, key, count,   i, j, v) {
  for (i = 1; i <= count; i++) {
    v = values[key, i] + 0
    for (j = i - 1; j >= 1 && sorted[j] > v; j--) sorted[j + 1] = sorted[j]
    sorted[j + 1] = v
  }
}
function middle(values, key, count) {
  sort(values, key, count)
  return count % 2 ? sorted[(count + 1) / 2] : (sorted[count / 2] + sorted[count / 2 + 1]) / 2
}
function spread(values, key, count, format) {
  sort(values, key, count)
  return sprintf(format "-" format, sorted[1], sorted[count])
}
# The hand count: 180 per touching contact, walls included; 150 per cluster; 20 per sphere.
function flops(c, run) { return 180 * (contacts[run] + walls[run]) + 150 * clusters[c] + 20 * spheres[c] }
function ratios(top, bottom, count, over, under,   i) {
  for (i = 1; i <= count; i++) ratio["", i] = over[top, i] / under[bottom, i]
}
END {
  print "CPU time of one core, medians over rounds (least-most); LAMMPS with gran/hooke/history, its fastest contact style\n"
  printf "%-24s  %13s  %-25s  %-25s  %-18s  %-16s  %s\n", "case", "contacts", "us/step", "us/step", "LAMMPS / ours", "M sphere-steps/s", "share"
  printf "%-24s  %6s %6s  %-25s  %-25s  %-18s  %-16s  %s\n", "", "LAMMPS", "ours", "LAMMPS", "ours", "", "LAMMPS  ours", "of peak"
  for (k = 1; k in order; k++) {
    c = order[k]; theirs = c SUBSEP "lammps" SUBSEP 1; ours = c SUBSEP "regolab" SUBSEP 1
    if (!n[ours] || !n[theirs]) continue
    a = middle(cpu, theirs, n[theirs]); b = middle(cpu, ours, n[ours])
    ratios(theirs, ours, n[ours], cpu, cpu)
    printf "%-24s  %6d %6d  %7.1f %-17s  %7.1f %-17s  %5.2f %-12s  %6.2f  %6.2f    %4.1f %%\n", title[c], contacts[theirs], contacts[ours], \
      a, "(" spread(cpu, theirs, n[theirs], "%.1f") ")", b, "(" spread(cpu, ours, n[ours], "%.1f") ")", \
      middle(ratio, "", n[ours]), "(" spread(ratio, "", n[ours], "%.2f") ")", spheres[c] / a, spheres[c] / b, \
      100 * flops(c, ours) / (b * 1e3 * peak)
  }
  printf "\npeak     %.1f GFLOP/s: AVX2 double multiply and add in registers, one core, best of all rounds\n", peak
  print "counted  flops per step, by hand: 180 per touching contact incl. walls + 150 per cluster + 20 per sphere"
  one = "C" SUBSEP "regolab" SUBSEP 1; two = "C" SUBSEP "regolab" SUBSEP 2
  if (n[two]) {
    ratios(one, two, n[two], wall, wall)
    printf "threads  C: %.1f us wall on one, %.1f on two: %.2f times (%s)\n", middle(wall, one, n[one]), middle(wall, two, n[two]), \
      middle(ratio, "", n[two]), spread(ratio, "", n[two], "%.2f")
  }
  print "\nSame state, same physics? Kinetic energy after 200 + N steps. The dashpots differ a little (LAMMPS's grows with the mass of the"
  print "pair), and settled beds are chaotic: expect a few per cent."
  for (k = 1; k in order; k++) {
    c = order[k]; theirs = c SUBSEP "lammps" SUBSEP 1; ours = c SUBSEP "regolab" SUBSEP 1
    if (!n[ours] || !n[theirs]) continue
    printf "  %-24s  N = %-6d LAMMPS %.4e J, ours %.4e J (%+.1f %%)\n", title[c], steps[c], kinetic[theirs], kinetic[ours], \
      100 * (kinetic[ours] / kinetic[theirs] - 1)
  }
}
