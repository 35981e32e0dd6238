#include "client/views/gap_text.h"

#include <fmt/format.h>

#include "client/table_print.h"

namespace regolab::client {

std::string import_text(const pb::ImportReply& reply) {
  std::string text = fmt::format("{}: {} numbers and {} curves, {} features\n\n", reply.name(), reply.scalars(), reply.curves(), reply.features_size());
  Table table({{.title = "feature", .align = Align::kLeft}, {.title = "value"}, {.title = "± error"}, {.title = "unit", .align = Align::kLeft},
               {.title = "repeats"}, {.title = "compared as"}, {.title = "± error"}, {.title = "where", .align = Align::kLeft}});
  for (const auto& f : reply.features()) {
    table.add({f.id(), fmt::format("{:.4g}", f.shown()), fmt::format("{:.2g}{}", f.shown_error(), f.assumed() ? " assumed" : ""), f.unit() == "1" ? "" : f.unit(),
               std::to_string(f.repeats()), fmt::format("{}{:.4g}", f.logarithm() ? "ln " : "", f.value()), fmt::format("{:.2g}", f.standard_error()), f.group()});
  }
  text += table.text();
  if (!reply.unused().empty()) text += "\nnot used\n";
  for (const auto& entry : reply.unused()) text += fmt::format("  {}: {}\n", entry.id(), entry.why());
  return text;
}

}  // namespace regolab::client
