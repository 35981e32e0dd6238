#include "client/views/functions_text.h"

#include <fmt/format.h>

#include <map>

#include "client/number_text.h"
#include "client/table_print.h"
#include "client/views/names.h"

namespace regolab::client {
namespace {

std::string r_text(bool known, double r) { return known ? fixed(r, 3) : "-"; }

/// The layout of Table 12, ours over the article's.
std::string group_table(const pb::TrainFunctionsReply& trained) {
  Table table({{"R", "", Align::kLeft}, {"", "", Align::kLeft}, {"training"}, {"validation"}, {"test"}, {"all"}});
  for (const auto& function : trained.functions()) {
    if (!function.problem().empty()) continue;
    std::vector<std::string> ours{function.name(), "ours"}, article{"", "article"};
    for (const auto& group : function.groups()) {
      ours.push_back(r_text(group.has_r(), group.r()));
      article.push_back(fixed(group.article_r(), 3));
    }
    table.add(std::move(ours));
    table.add(std::move(article));
  }
  return table.text();
}

std::string left_out_table(const pb::TrainFunctionsReply& trained) {
  Table table({{"left out", "", Align::kLeft},
               {"output", "", Align::kLeft},
               {"rows"},
               {"R"},
               {"R2"},
               {"rms error"},
               {"", "", Align::kLeft},
               {"of the mean", "%"}});
  for (const auto& function : trained.functions()) {
    for (const auto& output : function.outputs()) {
      const auto& q = output.left_out();
      table.add({function.name(), short_name(output.response()), std::to_string(q.rows()), r_text(q.has_r(), q.r()),
                 r_text(q.has_r2(), q.r2()), significant(q.rms(), 3), shown_unit(output.unit()),
                 fixed(100 * q.relative(), 1)});
    }
  }
  return table.text();
}

/// Functions trained on the same tests share a line.
std::string split_text(const pb::TrainFunctionsReply& trained) {
  std::map<std::string, std::vector<std::string>> by_split;
  for (const auto& function : trained.functions()) {
    if (!function.problem().empty()) continue;
    std::string points;
    for (const auto& group : function.groups()) {
      if (group.points_size() > 0) points += fmt::format("  {:<11}{}\n", group.name(), fmt::join(group.points(), " "));
    }
    by_split[points].push_back(function.name());
  }
  std::string text;
  for (const auto& [points, names] : by_split)
    text += fmt::format("split by test, seed {} ({})\n{}", trained.seed(), fmt::join(names, ", "), points);
  return text;
}

std::string networks_text(const pb::TrainFunctionsReply& trained) {
  std::string text;
  for (const auto& f : trained.functions()) {
    if (!f.problem().empty()) continue;
    const int tests = f.groups(0).points_size() + f.groups(1).points_size() + f.groups(2).points_size();
    const bool singly = static_cast<int>(f.folds()) == tests;
    text +=
        fmt::format("{}: {} inputs, {} hidden, {} weights ({} in use); start {} of {}; {} left out, {} networks averaged\n",
                    f.name(), f.inputs_size(), f.hidden(), f.weights(), fixed(f.weights_in_use(), 1), f.chosen_start(),
                    f.starts(), singly ? "one test at a time" : fmt::format("{} sets of tests", f.folds()), f.members());
  }
  return text;
}

}  // namespace

std::string functions_text(const pb::TrainFunctionsReply& trained) {
  std::string text = group_table(trained);
  text += "R = Pearson's, mean over the function's outputs; article = Table 12\n\n";
  text += left_out_table(trained);
  text += "left out = predicted by networks that saw no row of that test: what to expect of a new material\n\n";
  text += split_text(trained) + networks_text(trained);
  for (const auto& function : trained.functions()) {
    if (!function.problem().empty()) text += fmt::format("{} not trained: {}\n", function.name(), function.problem());
  }
  for (const auto& note : trained.notes()) text += "note: " + note + "\n";
  return text;
}

}  // namespace regolab::client
