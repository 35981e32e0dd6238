#include "client/views/gap_next.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "client/table_print.h"

namespace regolab::client {
namespace {

constexpr double kWorthIt = 0.05;  // [nat]; below, a test is not proposed by name

std::string pairs_of(const pb::NextTest& test) { return fmt::format("{}", fmt::join(test.splits(), "; ")); }

}  // namespace

std::string next_line(const pb::Diagnosis& d) {
  std::string text;
  for (const auto& test : d.next_tests()) {
    if (!test.has_eig_nats() || test.eig_nats() < kWorthIt) continue;
    text = fmt::format("{} ({:.2f} of {:.2f} nat, about {:.3g} h){}", test.test(), test.eig_nats(), d.open_nats(), test.hours(), test.splits().empty() ? "" : ": " + pairs_of(test));
    break;
  }
  for (const auto& test : d.next_tests()) {
    if (test.has_eig_nats()) continue;
    text += (text.empty() ? "" : "; not foretold: ") + fmt::format("{}: {}", test.test(), pairs_of(test));
    break;
  }
  return "next    " + (text.empty() ? fmt::format("nothing that the bank foretells would tell much more ({:.2f} nat are open)", d.open_nats()) : text);
}

std::string next_text(const pb::Diagnosis& d) {
  std::string text = fmt::format("{:.2f} nat are open between the causes; what a test is expected to tell, per hour of a laboratory (hours are assumed)\n\n", d.open_nats());
  Table table({{"test", "", Align::kLeft}, {"tells", "nat"}, {"takes", "h"}, {"a day", "nat"}, {"tells apart", "", Align::kLeft}});
  for (const auto& test : d.next_tests()) {
    if (!test.has_eig_nats()) continue;
    table.add({test.test(), fmt::format("{:.2f} ±{:.2f}", test.eig_nats(), test.eig_error()), fmt::format("{:.3g}", test.hours()), fmt::format("{:.2f}", 24 * test.eig_nats() / test.hours()), pairs_of(test)});
  }
  text += table.text();
  bool first = true;
  for (const auto& test : d.next_tests()) {
    if (test.has_eig_nats()) continue;
    if (std::exchange(first, false)) text += "\nnot foretold by any emulator: what would tell causes apart because it measures one of them\n";
    text += fmt::format("  {} (about {:.3g} h): {}\n", test.test(), test.hours(), pairs_of(test));
  }
  return text;
}

Json next_json(const pb::Diagnosis& d) {
  Json out = Json::array();
  for (const auto& test : d.next_tests()) {
    Json one{{"test", test.test()}, {"eig_nats", Json()}, {"eig_error", test.eig_error()}, {"hours", test.hours()}, {"splits", std::vector<std::string>(test.splits().begin(), test.splits().end())}};
    if (test.has_eig_nats()) one["eig_nats"] = test.eig_nats();
    out.push_back(std::move(one));
  }
  return out;
}

}  // namespace regolab::client
