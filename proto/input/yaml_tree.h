/// A YAML document as a tree that knows where everything stands. Stricter than YAML: no aliases, tags, duplicate keys.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/report.h"

namespace regolab {

struct YamlNode;

struct YamlKey {
  std::string text;
  Place place;
};

struct YamlNode {
  enum class Kind { kNull, kScalar, kList, kMap };
  Kind kind = Kind::kNull;
  Place place;
  std::string text = {};             ///< scalars
  std::vector<YamlKey> keys = {};    // [n_items], maps only
  std::vector<YamlNode> items = {};  ///< list items, or a map's values

  bool is_scalar() const { return kind == Kind::kScalar; }
  bool is_list() const { return kind == Kind::kList; }
  bool is_map() const { return kind == Kind::kMap; }
};

/// "a map", "a list", "text", "nothing": for messages.
std::string_view name_of(YamlNode::Kind kind);

inline constexpr std::size_t kLargestFile = 1 << 20;  ///< [bytes]; a design of 4096 rows takes a quarter of it
inline constexpr int kDeepest = 16;                   ///< levels of nesting; our files use 4
inline constexpr std::size_t kMostKeys = 10000;       ///< of one map; each is compared with all others

struct YamlLimits {
  std::size_t bytes = kLargestFile;
  std::size_t values = 1 << 20;  ///< keys and values; a hundred bytes of memory each
  std::string_view remedy = "put long tables into a CSV file";
};

/// What cannot be parsed (not text, not UTF-8, too large, too deep, bad YAML, empty) is reported and gives nothing; what can
/// be parsed but is refused (duplicate key, alias, tag) is reported and the rest of the tree is given, so that all errors
/// show.
std::optional<YamlNode> parse_yaml(std::string_view text, Report& report, const YamlLimits& limits = {});

/// The first byte that keeps `text` from being UTF-8 text without control characters; nothing when all is well.
std::optional<std::size_t> first_bad_byte(std::string_view text);

}  // namespace regolab
