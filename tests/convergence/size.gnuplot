# data-1.dat ... data-7.dat (material, clusters, mean, standard error) -> out
set terminal svg size 1000,680 font "sans,12" background "white"
set output out
set multiplot layout 2,2 title "Profile quick: what the number of clusters changes (means over seeds, one standard error)"
set logscale x
set xrange [80:10000]
set xlabel "clusters"
set grid lc rgb "#dddddd"
unset key
name(m) = m == 1 ? "4 elements, 0.1 deg" : m == 2 ? "6 elements, 20 deg" : "2 elements, 40 deg"
colour(m) = m == 1 ? "#1b6ca8" : m == 2 ? "#c4501b" : "#3a8f3a"
file(r) = sprintf("%s-%d.dat", data, r)
set offsets 0, 0, graph 0.05, graph 0.25
set ylabel "contacts per cluster"
plot for [m=1:3] file(1) using ($1 == m ? $2 : NaN):3:4 with yerrorlines lc rgb colour(m) pt 7 ps 0.6 title name(m)
set ylabel "bulk density, g/cm^3"
plot for [m=1:3] file(2) using ($1 == m ? $2 : NaN):3:4 with yerrorlines lc rgb colour(m) pt 7 ps 0.6
set ylabel "repose through the whole surface, deg"
plot for [m=1:3] file(5) using ($1 == m ? $2 : NaN):3:4 with yerrorlines lc rgb colour(m) pt 7 ps 0.6
set ylabel "sigma1 at 10 kPa, kPa"
set key bottom right
set yrange [0:*]
plot for [m=1:3] file(7) using ($1 == m ? $2 : NaN):3:4 with yerrorlines lc rgb colour(m) pt 7 ps 0.6 title name(m)
unset multiplot
