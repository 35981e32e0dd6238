#include "client/design_source.h"

#include <fmt/format.h>

#include <optional>
#include <random>

#include "client/console.h"
#include "client/file_read.h"
#include "input/report.h"
#include "input/yaml_tree.h"

namespace regolab::client {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kReadAtMost =
    16 << 20;  // [bytes] of a design; the reader refuses far smaller ones and names their size
constexpr std::size_t kLargestTable = 2 << 20;  // [bytes]; 4096 rows of 20 columns take half of it

const YamlNode* child_of(const YamlNode* map, std::string_view key) {
  if (map == nullptr || !map->is_map()) return nullptr;
  for (std::size_t i = 0; i < map->keys.size(); ++i) {
    if (map->keys[i].text == key) return &map->items[i];
  }
  return nullptr;
}

/// The CSV file of `array: {table: FILE}`; inline rows are none.
const YamlNode* table_of(const YamlNode& root) {
  const YamlNode* table = child_of(child_of(&root, "array"), "table");
  return table != nullptr && table->is_scalar() ? table : nullptr;
}

void attach(const YamlNode& table, const fs::path& design, pb::SubmitRequest& request, Report& report) {
  const fs::path path = fs::path(table.text).is_absolute() ? fs::path(table.text) : design.parent_path() / table.text;
  std::string why;
  const auto text = read_file(path, kLargestTable, why);
  if (!text) {
    report.add(table.place,
               fmt::format("cannot read the table {} ({}) name it relative to the design's folder", path.string(), why));
  } else if (text->size() > kLargestTable) {
    report.add(table.place, fmt::format("the table {} is too large (over {} bytes) a design has at most 4096 rows",
                                        path.string(), kLargestTable));
  } else {
    (*request.mutable_attachments())[table.text] = *text;
  }
}

}  // namespace

std::string new_request_id() {
  std::random_device random;
  std::string id;
  for (int i = 0; i < 4; ++i) id += fmt::format("{:08x}", random());
  return id;
}

Outcome read_design_source(const Arguments& arguments, pb::SubmitRequest& request, std::vector<Diagnostic>& diagnostics) {
  std::string why;
  const auto text = read_file(arguments.design, kReadAtMost, why);
  if (!text) {
    return failed(Exit::kInvalidInput,
                  fmt::format("{}: cannot read the design ({}) name a design.yaml, as client/examples/article-l32.yaml",
                              arguments.design, why));
  }
  request.set_request_id(new_request_id());
  request.set_file_name(arguments.design);
  request.set_design_yaml(*text);
  request.set_profile(arguments.profile);
  request.set_seeds(arguments.seeds);

  Report syntax(arguments.design, *text);
  const auto root = parse_yaml(*text, syntax);
  if (!root) {
    diagnostics = syntax.take();
    return failed(Exit::kInvalidInput, "");
  }
  Report tables(arguments.design, *text);
  if (const YamlNode* table = table_of(*root)) attach(*table, arguments.design, request, tables);
  diagnostics = tables.take();
  return diagnostics.empty() ? done() : failed(Exit::kInvalidInput, "");
}

std::string diagnostics_text(const std::vector<Diagnostic>& diagnostics, bool colour) {
  std::string text;
  for (Diagnostic diagnostic : diagnostics) {
    if (first_bad_byte(diagnostic.source_line)) diagnostic.source_line.clear();  // no bytes of a binary file on a terminal
    std::string one = to_text(diagnostic);
    if (colour) {
      if (const auto caret = one.rfind('^'); caret == one.size() - 1) one.replace(caret, 1, paint(true, Ink::kRed, "^"));
      if (const auto place = one.find(": "); place != std::string::npos)
        one = paint(true, Ink::kBold, one.substr(0, place)) + one.substr(place);
    }
    text += one + "\n";
  }
  if (diagnostics.size() > 1) text += fmt::format("{} problems; nothing was changed\n", diagnostics.size());
  return text;
}

std::vector<Diagnostic> from_proto(const google::protobuf::RepeatedPtrField<pb::Diagnostic>& diagnostics) {
  std::vector<Diagnostic> all;
  for (const pb::Diagnostic& d : diagnostics) {
    all.push_back({.file = d.file(),
                   .line = static_cast<int>(d.line()),
                   .column = static_cast<int>(d.column()),
                   .text = d.text(),
                   .source_line = d.source_line()});
  }
  return all;
}

}  // namespace regolab::client
