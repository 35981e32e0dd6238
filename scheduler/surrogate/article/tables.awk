# `regolab range --csv` of several studies (the file's name is the study's) -> ranges.csv, levels.csv, contrasts.csv in `out`.
# Levels of a factor are equally many and balanced over the others, so the error of a contrast is that of independent means.
BEGIN {
  FS = OFS = ","
  drawn["repose_angle", "theta_F"] = drawn["repose_angle", "K_N"] = drawn["repose_angle", "eta_T"] = 1
  drawn["sigma1_at_sigma3_1.25kPa", "L_S"] = drawn["sigma1_at_sigma3_10kPa", "L_S"] = 1
  # name; factor; weights of its levels, in the design's order
  asked[1] = "40 and 60 deg less 20 deg;theta_F;0 -1 0.5 0.5"
  asked[2] = "60 deg less 40 deg;theta_F;0 0 -1 1"
  asked[3] = "mixture less the mean of the three;N_E;-0.33333333333333333 -0.33333333333333333 -0.33333333333333333 1"
  asked[4] = "mixture less 2 elements;N_E;-1 0 0 1"
  asked[5] = "4 and 6 elements less 2;N_E;-1 0.5 0.5 0"
  asked[6] = "6 elements less 4;N_E;0 -1 1 0"
  asked[7] = "1e5 less 2.5e4 N/m;K_N;-1 0 0 1"
  asked[8] = "0.75 N s/m less the rest;eta_T;-0.33333333333333333 -0.33333333333333333 1 -0.33333333333333333"
  asked[9] = "0.5 less 1 cm;L_S;1 -1 0 0"
  asked[10] = "2 less 1 cm;L_S;0 -1 0 1"
  asked[11] = "x and xz less none and z;rotation;-0.5 0.5 -0.5 0.5"
  asked[12] = "z and xz less none and x;rotation;-0.5 -0.5 0.5 0.5"
  print "study,response,unit,mean,factor,R,R_standard_error,difference_95,F,p,R_without_one_run_min,R_without_one_run_max,leaning_on_point" > (out "/ranges.csv")
  print "study,response,unit,factor,level,mean,half_width_95" > (out "/levels.csv")
  print "study,contrast,response,unit,value,half_width_95" > (out "/contrasts.csv")
}
function digits(value) { return value == "" ? "" : sprintf("%.6g", value) }
FNR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
function at(name) { return $(column[name]) }
{
  study = FILENAME; response = at("response"); factor = at("factor")
  key = study OFS response OFS factor
  if (!(key in levels)) {
    print study, response, at("unit"), digits(at("mean")), factor, digits(at("R")), digits(at("R_standard_error")),
      study ~ /without/ ? "" : digits(at("half_width_95") * sqrt(2)), digits(at("F")), digits(at("p")), digits(at("R_without_one_run_min")),
      digits(at("R_without_one_run_max")), at("leaning_on_point") > (out "/ranges.csv")
    if (!((study, response) in seen)) { seen[study, response] = 1; pair[++pairs] = study OFS response; unit[pairs] = at("unit") }
  }
  n = ++levels[key]
  mean[key, n] = at("k_mean"); half[key, n] = at("half_width_95")
  if ((response, factor) in drawn && study != "article without 3 and 27")
    print study, response, at("unit"), factor, at("level"), digits(at("k_mean")), digits(at("half_width_95")) > (out "/levels.csv")
}
END {
  for (c = 1; c in asked; c++) {
    split(asked[c], part, ";"); split(part[3], weight, " ")
    for (p = 1; p <= pairs; p++) {
      if (pair[p] ~ /without/) continue
      key = pair[p] OFS part[2]; value = square = 0
      for (l = 1; l <= levels[key]; l++) { value += weight[l] * mean[key, l]; square += (weight[l] * half[key, l]) ^ 2 }
      split(pair[p], who, ",")
      print who[1], part[1], who[2], unit[p], digits(value), digits(sqrt(square)) > (out "/contrasts.csv")
    }
  }
}
