/// Reads a YAML map whose keys are known: says what is missing and what is unknown.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "input/yaml_tree.h"

namespace regolab {

class MapReader {
 public:
  /// `path` is what messages call this map ("micro"), empty for the file's top. `node` and `report` must outlive the reader.
  /// A node that is no map is reported here and then read as empty, without complaints about missing keys.
  MapReader(const YamlNode& node, std::string path, Report& report);

  /// The key's value, or null; the key counts as known from now on. An empty value is reported and given as null.
  const YamlNode* get(std::string_view key);

  /// As get; a missing key is reported with what to write ("K_N: 5e4 N/m").
  const YamlNode* need(std::string_view key, std::string_view example);

  /// Counts `key` as known, for suggestions, without reading it.
  void allow(std::string_view key) { known_.push_back(key); }

  /// Reports every key that was never asked for.
  void finish();

  bool is_map() const { return is_map_; }
  const YamlNode& node() const { return node_; }

  /// "micro.K_N"
  std::string path_of(std::string_view key) const;

 private:
  const YamlNode* find(std::string_view key) const;

  const YamlNode& node_;
  std::string path_;
  Report& report_;
  bool is_map_;
  std::vector<std::string_view> known_;
};

}  // namespace regolab
