#include "client/views/surrogate_text.h"

#include <fmt/format.h>

#include "client/number_text.h"
#include "client/table_print.h"
#include "client/views/names.h"

namespace regolab::client {
namespace {

std::string range_of(const pb::ModelInput& input) {
  if (input.labels().empty()) return fmt::format("{} to {}", significant(input.low(), 3), significant(input.high(), 3));
  return fmt::format("{}", fmt::join(input.labels().begin(), input.labels().end(), ", "));
}

std::string band(double low, double high) { return significant(low, 4) + " to " + significant(high, 4); }

std::string short_with_unit(const std::string& response, const std::string& unit) { return with_unit(short_name(response), unit); }

Table skill_table(const pb::ModelSummary& model) {
  Table table({{"response", "", Align::kLeft}, {"points"}, {"R"}, {"R2"}, {"rms error"}, {"error"}, {"in 90 % band"}});
  for (const auto& s : model.skills()) {
    table.add({short_with_unit(s.response(), s.unit()), std::to_string(s.points()), fixed(s.r(), 3), fixed(s.r2(), 3), significant(s.rms(), 2),
               fixed(100 * s.relative(), 1) + " %", fixed(100 * s.coverage(), 0) + " %"});
  }
  return table;
}

/// "0.5 to 60 deg of 0.1 to 60", or the choices left.
std::string freedom_of(const pb::Freedom& f) {
  if (!f.labels().empty()) return fmt::format("{}", fmt::join(f.labels().begin(), f.labels().end(), ", "));
  return band(f.low(), f.high());
}

}  // namespace

std::string model_text(const pb::ModelSummary& model) {
  std::string text = fmt::format("{}  {}, {} points{}\n", model.id(), model.name(), model.rows(),
                                 model.created_unix_ms() == 0 ? ", came with the program" : "");
  if (model.inputs().empty()) return text;
  for (const auto& input : model.inputs()) text += fmt::format("  {}: {}\n", with_unit(input.name(), input.unit()), range_of(input));
  for (const auto& [name, value] : model.fixed()) text += fmt::format("  {}: {} in all data\n", name, value);
  text += "each point left out in turn (hyperparameters kept):\n" + skill_table(model).text(2);
  return text + "R, R2 of the logarithm for stresses, moduli and forces" + (model.curves() ? "; stress-strain curves too" : "") + "\n";
}

std::string prediction_text(const pb::Prediction& prediction) {
  Table table({{"property", "", Align::kLeft}, {"value"}, {"one run, 90 %", "", Align::kLeft}, {"mean of many, 90 %", "", Align::kLeft}, {"unit", "", Align::kLeft}});
  for (const auto& e : prediction.estimates()) {
    table.add({short_name(e.response()), significant(e.value(), 4), band(e.low(), e.high()), band(e.mean_low(), e.mean_high()), shown_unit(e.unit())});
  }
  std::string text = table.text();
  for (const auto& line : prediction.assumed()) text += "assumed  " + line + "\n";
  for (const auto& line : prediction.outside()) text += "OUTSIDE THE DATA  " + line + ": extrapolated, do not trust the bands\n";
  return text;
}

std::string curve_text(const pb::EstimatedCurve& curve) {
  Table table({{"axial strain", "%"}, {"sigma1", "kPa"}, {"one run, 90 %", "", Align::kLeft}});
  for (int k = 0; k < curve.sigma1_size(); ++k) {
    const auto& e = curve.sigma1(k);
    table.add({fixed(100 * curve.axial_strain(k), 0), significant(e.value(), 4), band(e.low(), e.high())});
  }
  return fmt::format("\nsigma3 = {} kPa\n", shortest(curve.sigma3_pa() / 1000)) + table.text();
}

std::string material_text(const google::protobuf::Map<std::string, std::string>& set, const pb::InvertReply& reply) {
  std::string text;
  for (const auto& f : reply.freedom()) {
    const auto found = set.find(f.input());
    if (found != set.end()) text += (text.empty() ? "" : ", ") + f.input() + " " + found->second;
  }
  return text;
}

std::string inversion_text(const pb::InvertReply& reply) {
  std::vector<Column> columns{{"", "", Align::kLeft}};
  for (const auto& t : reply.targets()) columns.push_back({short_name(t.response()), shown_unit(t.unit())});
  columns.push_back({"all met", "probability"});
  Table table(std::move(columns));
  std::vector<std::string> wanted{"wanted"};
  for (const auto& t : reply.targets()) wanted.push_back(with_uncertainty(t.value(), t.tolerance()));
  wanted.emplace_back("");
  table.add(std::move(wanted));
  for (int i = 0; i < reply.candidates_size(); ++i) {
    const auto& c = reply.candidates(i);
    std::vector<std::string> cells{std::to_string(i + 1)};
    for (const auto& e : c.estimates()) cells.push_back(with_uncertainty(e.value(), 0.5 * (e.mean_high() - e.mean_low())));
    cells.push_back(fixed(100 * c.probability(), 0) + " %");
    table.add(std::move(cells));
  }
  std::string text = table.text() + "± of a candidate: where its mean over many runs lies with 90 %\n\n";
  for (int i = 0; i < reply.candidates_size(); ++i) {
    text += fmt::format("{:>3}  {}\n", i + 1, material_text(reply.candidates(i).set(), reply));
  }
  text += fmt::format("\nleft open by the targets ({} of {} materials spread over the box may fit):\n", reply.fitting(), reply.tried());
  for (const auto& f : reply.freedom()) text += fmt::format("  {}: {}\n", with_unit(f.input(), f.unit()), reply.fitting() ? freedom_of(f) : "-");
  for (const auto& note : reply.notes()) text += "note: " + note + "\n";
  return text;
}

}  // namespace regolab::client
