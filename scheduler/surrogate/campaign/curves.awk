# Stress-strain curves of an export, tidy: axial stress at every whole per cent of axial strain, by interpolation.
BEGIN { FS = ","; print "point,seed,sigma3_kPa,axial_strain_percent,sigma1_kPa" }
FNR == 1 {
  n = split(FILENAME, part, "/")
  point = substr(part[n - 2], 7) + 0
  seed = substr(part[n - 1], 6) + 0
  sigma3 = part[n]
  sub(/^stress_/, "", sigma3)
  sub(/kPa-.*/, "", sigma3)
  wanted = 0
  next
}
{
  while (wanted <= 20 && 100 * $1 >= wanted - 1e-9) {
    value = wanted == 0 || 100 * $1 == wanted ? $2 : y + ($2 - y) * (wanted - 100 * x) / (100 * ($1 - x))
    printf "%d,%d,%s,%d,%.4g\n", point, seed, sigma3, wanted, value
    ++wanted
  }
  x = $1
  y = $2
}
