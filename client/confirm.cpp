#include "client/confirm.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "client/csv_read.h"
#include "client/design_source.h"
#include "vocab/units.h"

namespace regolab::client {
namespace {

constexpr std::string_view kSigma1 = "sigma1_at_sigma3_";

/// "10 kPa" of every stress target.
std::vector<std::string> stresses_of(const pb::InvertReply& reply) {
  std::vector<std::string> out;
  for (const auto& t : reply.targets()) {
    if (!t.response().starts_with(kSigma1)) continue;
    std::string text = t.response().substr(kSigma1.size());
    text.insert(text.size() - 3, " ");  // before kPa
    if (std::find(out.begin(), out.end(), text) == out.end()) out.push_back(text);
  }
  return out;
}

bool needs_repose(const pb::InvertReply& reply) {
  return std::any_of(reply.targets().begin(), reply.targets().end(), [](const auto& t) { return t.response().starts_with("repose"); });
}

}  // namespace

unsigned runs_of_one(const pb::InvertReply& reply) {
  return 1 + (needs_repose(reply) ? 1 : 0) + static_cast<unsigned>(stresses_of(reply).size());
}

pb::SubmitRequest confirmation_design(const pb::InvertReply& reply, int candidates, unsigned seeds, const std::string& name) {
  std::vector<std::vector<std::string>> rows;
  for (int k = 0; k < candidates; ++k) rows.push_back(csv_cells(reply.candidates(k).design_row()));
  std::string fixed, header, profile = "quick";
  std::vector<std::size_t> varied;
  for (int c = 0; c < reply.columns_size(); ++c) {
    const auto at = static_cast<std::size_t>(c);
    const bool same = std::all_of(rows.begin(), rows.end(), [&](const auto& row) { return row[at] == rows[0][at]; });
    const std::string& input = reply.freedom(c).input();
    if (same) {
      fixed += (fixed.empty() ? "" : ", ") + input + ": " + reply.candidates(0).set().at(input);
    } else {
      header += (header.empty() ? "" : ",") + reply.columns(c);
      varied.push_back(at);
    }
  }
  if (const auto found = reply.candidates(0).set().find("profile"); found != reply.candidates(0).set().end()) profile = found->second;
  std::string table = header + "\n";
  for (const auto& row : rows) {
    for (std::size_t k = 0; k < varied.size(); ++k) table += (k ? "," : "") + row[varied[k]];
    table += "\n";
  }
  const auto stresses = stresses_of(reply);
  pb::SubmitRequest request;
  request.set_request_id(new_request_id());
  request.set_file_name(name + ".yaml");
  request.set_design_yaml(fmt::format("name: {}\nprofile: {}\nseeds: {}\narray: {{table: candidates.csv}}\nfixed: {{{}}}\ntests: [settle, contacts, density{}{}]\n{}",
                                      name, profile, seeds, fixed, needs_repose(reply) ? ", repose" : "", stresses.empty() ? "" : ", stress",
                                      stresses.empty() ? "" : fmt::format("stress: {{sigma3: [{}]}}\n", fmt::join(stresses, ", "))));
  (*request.mutable_attachments())["candidates.csv"] = table;
  return request;
}

std::vector<Confirmed> confirmed_of(const pb::InvertReply& reply, int candidates, const std::string& experiment, const pb::ResultsReply& results) {
  std::vector<Confirmed> out;
  for (int k = 0; k < candidates; ++k) {
    Confirmed one{.candidate = reply.candidates(k), .experiment = experiment, .point = k + 1};
    for (const auto& target : reply.targets()) {
      const auto column = std::find_if(results.responses().begin(), results.responses().end(), [&](const auto& r) { return r.id() == target.response(); });
      const double factor = column == results.responses().end() ? 1 : door_unit(column->unit_si()).factor;
      double sum = 0, squares = 0;
      int n = 0;
      for (const auto& row : results.rows()) {
        const auto value = row.value_si().find(target.response());
        if (row.point() != k + 1 || value == row.value_si().end()) continue;
        sum += value->second * factor, squares += value->second * factor * value->second * factor, ++n;
      }
      const double mean = n ? sum / n : NAN;
      one.mean.push_back(mean);
      one.standard_error.push_back(n > 1 ? std::sqrt(std::max(0.0, squares / n - mean * mean) / (n - 1)) : NAN);
      one.seeds = std::max(one.seeds, n);
      one.miss = std::isnan(mean) ? INFINITY : std::max(one.miss, std::abs(mean - target.value()) / target.tolerance());
    }
    out.push_back(std::move(one));
  }
  return out;
}

}  // namespace regolab::client
