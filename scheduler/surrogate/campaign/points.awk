# The campaign's points: a rank-1 low-discrepancy sequence over the article's parameter box [Roberts 2018, generalised golden ratio],
# friction a little denser where it matters most, a third of the points under Earth's gravity.
#   awk -v n=192 -f points.awk >points.csv
function share(j) { u = 0.5 + k / phi ^ j; return u - int(u) }
function between(low, high, j) { return low + (high - low) * share(j) }
BEGIN {
  d = 9
  phi = 2
  for (i = 0; i < 60; ++i) phi = (1 + phi) ^ (1 / (d + 1))  # phi^(d+1) = phi + 1
  split("2 4 6 mixture", kind, " ")
  split("none x z xz", turned, " ")
  print "theta_F_deg,K_N_N_per_m,eta_N_N_s_per_m,K_T_N_per_m,eta_T_N_s_per_m,L_S_cm,N_E,rotation,gravity_m_per_s2"
  for (k = 1; k <= n; ++k) {
    printf "%.2f,%.0f,%.4f,%.0f,%.4f,%.4f,%s,%s,%s\n", 0.1 + 59.9 * share(1) ^ 1.4, between(2.5e4, 1e5, 2), between(0.25, 1, 3),
           between(2.5e4, 1e5, 4), between(0.25, 1, 5), between(0.5, 2, 6), kind[1 + int(4 * share(7))],
           turned[1 + int(4 * share(8))], share(9) < 1 / 3 ? "9.8" : "1.63"
  }
}
