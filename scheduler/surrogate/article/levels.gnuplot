# levels.csv -> levels.svg: level means with 95 % half widths, from each study's own residual.
set datafile separator ","
set terminal svg size 1080,720 font "DejaVu Sans,13" background "white"
set output "levels.svg"
colour(s) = s == 1 ? "#D55E00" : s == 2 ? "#56B4E9" : "#0072B2"
study(s) = word("article quick standard", s)
mine(s) = strcol(1) eq study(s) && strcol(2) eq r && strcol(4) eq f
set multiplot layout 2,3 margins 0.065,0.985,0.085,0.91 spacing 0.075,0.14 title "Level means: the article's 32 tests and ours" font ",16"
set grid y lc rgb "#dddddd"
unset key
set bars 0.6
do for [p=1:5] {
  r = word("repose_angle repose_angle repose_angle sigma1_at_sigma3_1.25kPa sigma1_at_sigma3_10kPa", p)
  f = word("theta_F K_N eta_T L_S L_S", p)
  sigma3 = p < 4 ? 1 : p == 4 ? 1.25 : 10
  scale = p == 2 ? 1e-4 : 1
  step = word("20 2.5 0.25 0.5 0.5", p) + 0
  set xtics step
  set xrange [(p == 1 ? -6 : 0.6 * step):(p == 1 ? 66 : 4.4 * step)]
  set xlabel p == 1 ? "θ_F, deg" : p == 2 ? "K_N, 10^4  N/m" : p == 3 ? "η_T, N s/m" : "L_S, cm"
  set ylabel p < 4 ? "angle of repose, deg" : p == 4 ? "critical σ₁/σ₃ at σ₃ = 1.25 kPa" : "critical σ₁/σ₃ at σ₃ = 10 kPa" offset 0.7
  if (p < 4) { set yrange [15:52]; set ytics 10 }
  if (p == 4) { set yrange [1:70]; set logscale y; set ytics (1, 2, 5, 10, 20, 50) }
  if (p == 5) { set yrange [1:70] }
  x(s) = $5 * scale + 0.05 * step * (s - 2)
  y(s) = mine(s) ? $6 / sigma3 : NaN
  bar(s) = mine(s) ? $7 / sigma3 : NaN
  plot for [s=1:3] "levels.csv" using (x(s)):(y(s)):(bar(s)) with yerrorlines lc rgb colour(s) lw 1.6 pt 3 + 2 * s ps 0.8
}
unset xlabel; unset ylabel; unset tics; unset border; unset grid; unset logscale
set xrange [0:1]
set yrange [0:1]
set key at graph -0.04, graph 0.95 left top Left reverse samplen 1.5 spacing 1.6
set label 1 "bars: 95 % of a level mean," at graph -0.02, graph 0.42
set label 2 "from the residual of each study" at graph -0.02, graph 0.33
set label 3 "(7 degrees of freedom)" at graph -0.02, graph 0.24
plot for [s=1:3] NaN with linespoints lc rgb colour(s) lw 1.6 pt 3 + 2 * s ps 1.1 title s == 1 ? "the article, one run a test" : s == 2 ? "ours, profile quick, 3 seeds" : "ours, profile standard, 3 seeds"
unset multiplot
