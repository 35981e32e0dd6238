# The straight line through the four stresses of each test of Table 9: the mean intercept for each L_S, and the power of L_S that it
# follows. A strength of the material would not know L_S (power 0); a stress held by elastic grains or by the boundary goes as 1/L_S.
#   awk -F, -f intercept.awk table-9.csv
NR == 1 { split("1.25 2.5 5 10", x, " "); next }
{
  sx = sy = sxx = sxy = 0
  for (k = 1; k <= 4; k++) { y = $(9 + k); sx += x[k]; sy += y; sxx += x[k] * x[k]; sxy += x[k] * y }
  b = (4 * sxy - sx * sy) / (4 * sxx - sx * sx)
  sum[$3] += (sy - b * sx) / 4; slope[$3] += b; n[$3]++
}
END {
  for (l in n) order[++m] = l + 0
  for (i = 1; i <= m; i++) for (j = i + 1; j <= m; j++) if (order[j] < order[i]) { t = order[i]; order[i] = order[j]; order[j] = t }
  print "| L_S, cm | intercept, kPa | slope |"; print "|---|---|---|"
  for (i = 1; i <= m; i++) {
    l = order[i]; c = sum[l] / n[l]
    printf "| %s | %.0f | %.1f |\n", l, c, slope[l] / n[l]
    u = log(l); v = log(c); su += u; sv += v; suu += u * u; suv += u * v
  }
  printf "\nintercept ~ L_S^%.2f\n", (m * suv - su * sv) / (m * suu - su * su)
}
