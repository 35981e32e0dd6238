# stress-strain.csv -> stress-strain.svg
set datafile separator ","
set terminal svg size 900,420 font "sans,12" background "white"
set output "stress-strain.svg"
set multiplot layout 1,2 title "Confined compression of the article's own sets, our DEM (1600 clusters, mean of two seeds)"
set xlabel "axial strain, %"
set ylabel "σ_1 / σ_3"
set yrange [0:4]
set key bottom right
array stress[4] = ["1.25", "2.5", "5", "10"]
array colour[4] = ["#0072b2", "#56b4e9", "#e69f00", "#d55e00"]
name(set) = set == 1 ? "JSC-1 [Table 14]: 2 elements, 40 deg" : "FJS-1 [Table 15]: 6 elements, 10 deg, K 3.5 kN/m"
do for [set = 1:2] {
  set title name(set)
  plot for [k = 1:4] "stress-strain.csv" using (column("set") == set && column("sigma3_kPa") == stress[k] + 0 ? column("axial_strain_percent") : NaN):"sigma1_over_sigma3" \
    with lines lw 2 lc rgb colour[k] title "σ_3 = ".stress[k]." kPa"
}
unset multiplot
