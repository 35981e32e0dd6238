# ranges.csv -> ranges.svg: R of every factor, a panel per response. Filled: the F test gives p < 0.05. Bars: the 95 % half width of the
# difference of two level means, from each study's own residual.
set datafile separator ","
set terminal svg size 1080,1040 font "DejaVu Sans,13" background "white"
set output "ranges.svg"
factors = "theta_F N_E K_N K_T eta_N eta_T L_S rotation"
studies = "article quick standard"
colour(s) = s == 1 ? "#D55E00" : s == 2 ? "#56B4E9" : "#0072B2"
place(name) = sum [i=1:words(factors)] (word(factors, i) eq name ? i : 0)
mine(s, r) = strcol(1) eq word(studies, s) && strcol(2) eq r
x(s) = place(strcol(5)) + 0.24 * (s - 2)
set multiplot layout 3,2 margins 0.08,0.985,0.05,0.93 spacing 0.085,0.075 title "Range factor R = largest less smallest level mean: the article's 32 tests and ours" font ",16"
set xrange [0.5:8.5]
set xtics ("θ_F" 1, "N_E" 2, "K_N" 3, "K_T" 4, "η_N" 5, "η_T" 6, "L_S" 7, "rotation" 8) scale 0
set grid y lc rgb "#dddddd"
do for [i=1:7] { set arrow from i+0.5, graph 0 to i+0.5, graph 1 nohead lc rgb "#eeeeee" back }
set arrow from graph 0, first 0 to graph 1, first 0 nohead lc rgb "#888888" back
unset key
set bars 0.6
do for [p=1:5] {
  r = word("contacts_per_particle bulk_density repose_angle sigma1_at_sigma3_1.25kPa sigma1_at_sigma3_10kPa", p)
  relative = p > 3
  set ylabel p == 1 ? "R, contacts" : p == 2 ? "R, g/cm^3" : p == 3 ? "R, deg" : "R / mean of σ₁" offset 0.5
  if (p == 1) { set title "contacts per particle" }
  if (p == 2) { set title "bulk density" }
  if (p == 3) { set title "angle of repose" }
  if (p == 4) { set title "critical σ₁ at σ₃ = 1.25 kPa, relative" }
  if (p == 5) { set title "critical σ₁ at σ₃ = 10 kPa, relative" }
  y(s) = mine(s, r) ? (relative ? $6 / $4 : $6) : NaN
  bar(s) = mine(s, r) ? (relative ? $8 / $4 : $8) : NaN
  sure(s) = $10 < 0.05 ? y(s) : NaN
  open(s) = $10 >= 0.05 ? y(s) : NaN
  plot for [s=1:3] "ranges.csv" using (x(s)):(y(s)):(bar(s)) with yerrorbars lc rgb colour(s) lw 1.6 pt 0, \
    for [s=1:3] "" using (x(s)):(sure(s)) with points lc rgb colour(s) pt 3 + 2 * s ps 0.9, \
    for [s=1:3] "" using (x(s)):(open(s)) with points lc rgb "white" pt 3 + 2 * s ps 0.9, \
    for [s=1:3] "" using (x(s)):(open(s)) with points lc rgb colour(s) lw 1.6 pt 2 + 2 * s ps 0.9
}
unset title; unset xlabel; unset ylabel; unset arrow; unset tics; unset border; unset grid
set yrange [0:1]
set key at graph 0.02, graph 0.95 left top Left reverse samplen 1.5 spacing 1.6 font ",14"
set label 1 "filled: p < 0.05 in the F test; open: not told from nothing" at graph 0.02, graph 0.42
set label 2 "bars: ± 95 % of the difference of two level means," at graph 0.02, graph 0.30
set label 3 "from the residual of each study (7 degrees of freedom)" at graph 0.02, graph 0.21
set label 4 "R of a factor without effect is 0.6 of its bar on average" at graph 0.02, graph 0.09
plot for [s=1:3] NaN with points lc rgb colour(s) pt 3 + 2 * s ps 1.2 title s == 1 ? "the article, one run a test" : s == 2 ? "ours, profile quick, 3 seeds" : "ours, profile standard, 3 seeds"
unset multiplot
