# fresh.csv -> fresh.svg: runs of materials the surrogate has never seen, against what it said, with the 90 % band of one run.
if (!exists("runs")) runs = "fresh.csv"
if (!exists("out")) out = "fresh.svg"
set datafile separator ","
set terminal svg size 960,940 font "DejaVu Sans,13" background "white"
set output out
set multiplot layout 2,2 margins 0.085,0.975,0.07,0.9 spacing 0.1,0.12 title "Predicted, with the 90 % band of one run, against measured: materials the model has not seen" font ",15"
set grid lc rgb "#dddddd"
unset key
set bars 0
set size square
do for [p=1:4] {
  r = word("bulk_density contacts_per_particle repose_angle sigma1_at_sigma3_10kPa", p)
  name = p == 1 ? "bulk density, g/cm^3" : p == 2 ? "contacts per particle" : p == 3 ? "angle of repose, deg" : "critical σ₁ at σ₃ = 10 kPa, kPa"
  one(v) = strcol(1) eq r ? v : NaN
  inside(v) = $4 >= $6 && $4 <= $7 ? one(v) : NaN
  outside(v) = $4 < $6 || $4 > $7 ? one(v) : NaN
  set xrange [*:*]
  set yrange [*:*]
  stats runs using (one($4)):(one($5)) nooutput name "all"
  stats runs using (inside($4)) nooutput name "in"
  stats runs using (one($6)):(one($7)) nooutput name "band"
  least = all_min_x < band_min_x ? all_min_x : band_min_x
  most = all_max_x > band_max_y ? all_max_x : band_max_y
  edge = 0.03 * (most - least)
  set xrange [least - edge:most + edge]
  set yrange [least - edge:most + edge]
  set xlabel "measured: " . name
  set ylabel "predicted" offset 0.5
  set label 1 sprintf("R %.3f, %d of %d runs in the band", all_correlation, in_records, all_records) at graph 0.04, graph 0.94
  plot x with lines lc rgb "#888888", \
    runs using (inside($4)):(inside($6)):(0):($7 - $6) with vectors nohead lc rgb "#8fbcdc" lw 1, \
    runs using (outside($4)):(outside($6)):(0):($7 - $6) with vectors nohead lc rgb "#eab08a" lw 1, \
    runs using (inside($4)):(inside($5)) with points lc rgb "#0072B2" pt 7 ps 0.4, \
    runs using (outside($4)):(outside($5)) with points lc rgb "#D55E00" pt 5 ps 0.5
}
unset multiplot
