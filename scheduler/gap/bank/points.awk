# Points for one effect: every sixth material of the null design, so that each run has a partner without the effect (same material, same
# seed), with a strength of its own. Strengths follow the golden ratio over the range from `phase` on, in its logarithm where `by_ratio` is 1.
#   awk -F, -v effect=cohesion_kPa -v low=0.02 -v high=20 -v by_ratio=1 -v offset=1 -v phase=0.5 -f points.awk ../../surrogate/campaign/points.csv
BEGIN { OFS = "," }
NR == 1 { print $0, effect; next }
(NR - 2) % 6 == offset {
  share = phase + 0.6180339887 * n++
  share -= int(share)
  strength = by_ratio ? low * (high / low) ^ share : low + (high - low) * share
  print $0, sprintf("%.5g", strength)
}
