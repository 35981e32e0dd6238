/// The shipped model on materials that it never learned from, drawn at random (scheduler/surrogate/campaign/fresh.yaml).
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "scheduler/surrogate/material.h"
#include "scheduler/surrogate/model.h"
#include "vocab/units.h"

namespace regolab::surrogate {
namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> out;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) out.push_back(cell);
  return out;
}

/// One run, as the table has it.
using Run = std::map<std::string, std::string>;
std::vector<Run> runs() {
  std::ifstream in(REGOLAB_SOURCE "/scheduler/surrogate/data/fresh.csv");
  std::string line;
  std::getline(in, line);
  const auto header = cells(line);
  std::vector<Run> out;
  while (std::getline(in, line)) {
    const auto row = cells(line);
    Run run;
    for (std::size_t k = 0; k < row.size(); ++k) run[header[k]] = row[k];
    out.push_back(std::move(run));
  }
  return out;
}

std::vector<double> inputs(const Model& model, const Run& run) {
  const std::map<std::string, std::string> text{
      {"theta_F", run.at("theta_F_deg") + " deg"},     {"K_N", run.at("K_N_N_per_m") + " N/m"},       {"eta_N", run.at("eta_N_N_s_per_m") + " N s/m"},
      {"K_T", run.at("K_T_N_per_m") + " N/m"},         {"eta_T", run.at("eta_T_N_s_per_m") + " N s/m"}, {"L_S", run.at("L_S_cm") + " cm"},
      {"N_E", run.at("N_E")},                          {"rotation", run.at("rotation")},               {"gravity", run.at("gravity_m_per_s2") + " m/s2"},
      {"particles", "300"},                            {"profile", "quick"}};
  const auto material = read_material(model, text);
  EXPECT_TRUE(material.ok()) << material.error().text;
  return material->x;
}

struct Score {
  double r = 0, coverage = 0;
  int runs = 0;
};
Score score(const std::string& response, const std::string& column, double factor, bool logarithm) {
  const Model& model = *shipped_model();
  double m = 0, p = 0, mm = 0, pp = 0, mp = 0, within = 0;
  int n = 0;
  for (const Run& run : runs()) {
    const auto cell = run.find(column);
    if (cell == run.end() || cell->second.empty()) continue;
    const double measured = std::stod(cell->second) / factor;
    for (const Estimate& e : model.predict(inputs(model, run))) {
      if (e.id != response) continue;
      const double a = logarithm ? std::log(measured) : measured, b = logarithm ? std::log(e.value) : e.value;
      m += a, p += b, mm += a * a, pp += b * b, mp += a * b, ++n;
      within += e.low <= measured && measured <= e.high ? 1 : 0;
    }
  }
  return {(mp - m * p / n) / std::sqrt((mm - m * m / n) * (pp - p * p / n)), within / n, n};
}

struct Claim {
  const char *response, *column;
  bool logarithm;
  const char* unit;
  double least_r;
};
class Fresh : public testing::TestWithParam<Claim> {};
TEST_P(Fresh, OneRunOfAMaterialNobodyChoseFallsIntoItsBand) {
  const Claim& claim = GetParam();
  const Score found = score(claim.response, claim.column, door_unit(claim.unit).factor, claim.logarithm);
  EXPECT_GE(found.runs, 40);
  EXPECT_GT(found.r, claim.least_r) << claim.response;
  // 48 runs: 90 % are 43, and a fair band holds 38 to 47 of them with 95 %.
  EXPECT_GE(found.coverage, 38.0 / 48);
  EXPECT_LE(found.coverage, 1.0);
  RecordProperty("r", std::to_string(found.r));
  RecordProperty("coverage", std::to_string(found.coverage));
  std::printf("%s: R %.3f, %.0f %% of %d runs in the 90 %% band\n", claim.response, found.r, 100 * found.coverage, found.runs);
}
// No R is asked of slopes and strengths: nearly all random materials stand on the plateau above 10 degrees of friction, where single beds
// scatter (6 degrees, 8 %) as much as materials differ.
INSTANTIATE_TEST_SUITE_P(Responses, Fresh,
                         testing::Values(Claim{"bulk_density", "bulk_density_g_per_cm3", false, "kg/m3", 0.98}, Claim{"contacts_per_particle", "contacts_per_particle", false, "1", 0.98},
                                         Claim{"repose_angle", "repose_angle_deg", false, "rad", -1},
                                         Claim{"sigma1_at_sigma3_1.25kPa", "sigma1_at_sigma3_1.25kPa_kPa", true, "Pa", -1},
                                         Claim{"sigma1_at_sigma3_10kPa", "sigma1_at_sigma3_10kPa_kPa", true, "Pa", -1}),
                         [](const auto& one) { return std::string(one.param.column).substr(0, 12) + std::to_string(one.index); });

}  // namespace
}  // namespace regolab::surrogate
