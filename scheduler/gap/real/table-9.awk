# An observation file for each of the article's 32 tests, OUT/table-9-TEST.yaml. Stated: what the article varies and whose unit is not in
# doubt (friction angle, L_S, N_E, rotation); stiffness and damping are integrated out. One run a test and no error: the residual standard
# deviation of the additive model over all 32 stands in (contacts 0.19, density 0.022 g/cm3, repose 5.1 deg; sigma1 15, 12, 20, 33 kPa,
# taken as the shares of the means over all tests that they are), an upper limit of what a run scatters by.
#   awk -F, -v out=DIR -f table-9.awk table-9.csv
function scalar(id, value, unit, error) { printf "- {id: %s, value: %s, unit: %s, standard_error: %.4g, seeds: 1}\n", id, value, unit, error > file }
NR == 1 { split("1.25 2.5 5 10", level, " "); split("15 12 20 33", residual, " "); next }
{ for (i = 1; i <= NF; i++) cell[NR, i] = $i; for (k = 1; k <= 4; k++) sum[k] += $(9 + k); last = NR }
END {
  for (k = 1; k <= 4; k++) share[k] = residual[k] / (sum[k] / (last - 1))
  for (r = 2; r <= last; r++) {
    file = sprintf("%s/table-9-%02d.yaml", out, cell[r, 1])
    printf "format: observations/1\ncase: article-test-%d\n", cell[r, 1] > file
    printf "material: {theta_F_deg: %s, nominal_max_size_cm: %s, N_E: %s, rotation: %s, particle_density_g_cm3: 2.93}\n", cell[r, 2], cell[r, 3], cell[r, 4], cell[r, 5] > file
    printf "specimen: {particles: 1000, repeats: 1}\nnominal_protocol: {gravity_m_s2: 1.63, sigma3_kPa: [1.25, 2.5, 5, 10]}\nobservables:\n" > file
    scalar("contacts_per_particle", cell[r, 6], "1", 0.19)
    scalar("bulk_density", cell[r, 7], "g/cm3", 0.022)
    scalar("repose_angle", cell[r, 9], "deg", 5.1)
    for (k = 1; k <= 4; k++) scalar("sigma1_at_sigma3_" level[k] "kPa", cell[r, 9 + k], "kPa", share[k] * cell[r, 9 + k])
    close(file)
  }
}
