#include "client/confirm.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

bool same_material(const pb::Candidate& a, const pb::Candidate& b) { return a.design_row() == b.design_row(); }

std::string setting(const pb::Candidate& candidate, const std::string& name, const std::string& otherwise) {
  const auto found = candidate.set().find(name);
  return found == candidate.set().end() ? otherwise : found->second;
}

}  // namespace

double MeasuredTarget::mean() const {
  double sum = 0;
  for (const double v : runs) sum += v;
  return runs.empty() ? NAN : sum / static_cast<double>(runs.size());
}

double MeasuredTarget::standard_error() const {
  const double centre = mean(), n = static_cast<double>(runs.size());
  double squares = 0;
  for (const double v : runs) squares += (v - centre) * (v - centre);
  return runs.size() < 2 ? NAN : std::sqrt(squares / (n - 1) / n);
}

double MeasuredTarget::miss() const { return runs.empty() ? std::numeric_limits<double>::infinity() : std::abs(mean() - value) / tolerance; }

double Confirmed::miss() const {
  double worst = 0;
  for (const MeasuredTarget& t : targets) worst = std::max(worst, t.miss());
  return worst;
}

bool Confirmed::met() const { return std::ranges::all_of(targets, &MeasuredTarget::met); }

bool Confirmed::open() const {
  const auto possible = [](const MeasuredTarget& t) { return t.runs.size() > 1 && std::abs(t.mean() - t.value) <= t.tolerance + 2 * t.standard_error(); };
  return !met() && std::ranges::all_of(targets, possible);
}

std::vector<pb::Candidate> next_round(const std::vector<Confirmed>& tried, const pb::InvertReply& reply, std::size_t count) {
  std::vector<const Confirmed*> open;
  for (const Confirmed& one : tried) {
    if (one.open()) open.push_back(&one);
  }
  std::ranges::sort(open, {}, [](const Confirmed* c) { return c->miss(); });
  std::vector<pb::Candidate> out;
  for (const Confirmed* one : open) {
    if (out.size() < count) out.push_back(one->candidate);
  }
  for (const pb::Candidate& proposed : reply.candidates()) {
    const bool known = std::ranges::any_of(tried, [&](const Confirmed& c) { return same_material(c.candidate, proposed); });
    if (out.size() < count && !known) out.push_back(proposed);
  }
  return out;
}

unsigned runs_of_one(const pb::InvertReply& reply) {
  return 1 + (needs_repose(reply) ? 1 : 0) + static_cast<unsigned>(stresses_of(reply).size());
}

pb::SubmitRequest confirmation_design(const pb::InvertReply& reply, std::span<const pb::Candidate> candidates, RoundSeeds seeds, const std::string& name) {
  std::vector<std::vector<std::string>> rows;
  for (const pb::Candidate& candidate : candidates) rows.push_back(csv_cells(candidate.design_row()));
  std::string fixed, header;
  std::vector<std::size_t> varied;
  for (int c = 0; c < reply.columns_size(); ++c) {
    const auto at = static_cast<std::size_t>(c);
    const bool same = std::all_of(rows.begin(), rows.end(), [&](const auto& row) { return row[at] == rows[0][at]; });
    const std::string& input = reply.freedom(c).input();
    if (same && !(varied.empty() && c + 1 == reply.columns_size())) {  // a table varies something, if only by name
      fixed += (fixed.empty() ? "" : ", ") + input + ": " + candidates[0].set().at(input);
    } else {
      header += (header.empty() ? "" : ",") + reply.columns(c);
      varied.push_back(at);
    }
  }
  std::string table = header + "\n";
  for (const auto& row : rows) {
    for (std::size_t k = 0; k < varied.size(); ++k) table += (k ? "," : "") + row[varied[k]];
    table += "\n";
  }
  std::vector<std::uint64_t> numbers;
  for (unsigned k = 0; k < seeds.count; ++k) numbers.push_back(seeds.first + k);
  const auto stresses = stresses_of(reply);
  const std::string particles = setting(candidates[0], "particles", "");
  pb::SubmitRequest request;
  request.set_request_id(new_request_id());
  request.set_file_name(name + ".yaml");
  request.set_design_yaml(fmt::format("name: {}\nprofile: {}\n{}seeds: [{}]\narray: {{table: candidates.csv}}\nfixed: {{{}}}\ntests: [settle, contacts, density{}{}]\n{}", name,
                                      setting(candidates[0], "profile", "quick"), particles.empty() ? "" : fmt::format("particles: {}\n", particles),
                                      fmt::join(numbers, ", "), fixed, needs_repose(reply) ? ", repose" : "", stresses.empty() ? "" : ", stress",
                                      stresses.empty() ? "" : fmt::format("stress: {{sigma3: [{}]}}\n", fmt::join(stresses, ", "))));
  (*request.mutable_attachments())["candidates.csv"] = table;
  return request;
}

void learn(const pb::InvertReply& reply, std::span<const pb::Candidate> candidates, const std::string& experiment, const pb::ResultsReply& results,
           std::vector<Confirmed>& tried) {
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    auto one = std::ranges::find_if(tried, [&](const Confirmed& c) { return same_material(c.candidate, candidates[k]); });
    if (one == tried.end()) {
      Confirmed added{.candidate = candidates[k], .experiments = {}, .targets = {}};
      for (const auto& target : reply.targets()) added.targets.push_back({.runs = {}, .value = target.value(), .tolerance = target.tolerance()});
      one = tried.insert(tried.end(), std::move(added));
    }
    one->experiments.push_back(experiment);
    for (int t = 0; t < reply.targets_size(); ++t) {
      const std::string& id = reply.targets(t).response();
      const auto column = std::ranges::find_if(results.responses(), [&](const auto& r) { return r.id() == id; });
      const double factor = column == results.responses().end() ? 1 : door_unit(column->unit_si()).factor;
      for (const auto& row : results.rows()) {
        const auto value = row.value_si().find(id);
        if (row.point() == static_cast<int>(k) + 1 && value != row.value_si().end()) one->targets[static_cast<std::size_t>(t)].runs.push_back(value->second * factor);
      }
    }
  }
}

const Confirmed* best_of(const std::vector<Confirmed>& tried) {
  const auto best = std::ranges::min_element(tried, {}, [](const Confirmed& c) { return std::pair(!c.met(), c.miss()); });
  return best == tried.end() ? nullptr : &*best;
}

}  // namespace regolab::client
