# `regolab predict --table points.csv --csv` and the measured table of the same points -> a line per run: measured beside predicted.
BEGIN {
  FS = OFS = ","
  kinds = split("bulk_density contacts_per_particle repose_angle sigma1_at_sigma3_10kPa", kind, " ")
  split("bulk_density_g_per_cm3 contacts_per_particle repose_angle_deg sigma1_at_sigma3_10kPa_kPa", header, " ")
  print "response,point,seed,measured,predicted,low_90,high_90"
}
FNR == 1 { ++file; split("", column); for (i = 1; i <= NF; i++) column[$i] = i; next }
file == 1 { said[$column["material"], $column["response"]] = $column["value"] OFS $column["low_90"] OFS $column["high_90"]; next }
{
  for (k = 1; k <= kinds; k++) {
    measured = $column[header[k]]
    if (measured != "") print kind[k], $1, $2, measured, said[$1, kind[k]]
  }
}
