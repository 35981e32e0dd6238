#include "input/map_reader.h"

#include <algorithm>
#include <utility>

#include "input/suggestion.h"

namespace regolab {

MapReader::MapReader(const YamlNode& node, std::string path, Report& report)
    : node_(node), path_(std::move(path)), report_(report), is_map_(node.is_map()) {
  if (!is_map_) {
    report_.add(node.place, (path_.empty() ? "the file" : path_) + " is " + std::string(name_of(node.kind)) +
                                " (must be a map) write lines of `key: value`");
  }
}

std::string MapReader::path_of(std::string_view key) const {
  return path_.empty() ? std::string(key) : path_ + "." + std::string(key);
}

const YamlNode* MapReader::find(std::string_view key) const {
  const auto found = std::find_if(node_.keys.begin(), node_.keys.end(), [&](const YamlKey& k) { return k.text == key; });
  return found == node_.keys.end() ? nullptr : &node_.items[static_cast<std::size_t>(found - node_.keys.begin())];
}

const YamlNode* MapReader::get(std::string_view key) {
  known_.push_back(key);
  const YamlNode* value = find(key);
  if (value != nullptr && value->kind == YamlNode::Kind::kNull) {
    report_.add(node_.keys[static_cast<std::size_t>(value - node_.items.data())].place,
                path_of(key) + " has no value (the key stands alone) give one or remove the line");
    return nullptr;
  }
  return value;
}

const YamlNode* MapReader::need(std::string_view key, std::string_view example) {
  const YamlNode* value = get(key);
  if (value == nullptr && is_map_ && find(key) == nullptr) {
    report_.add(node_.place,
                "missing key '" + path_of(key) + "' (nothing stands in for it) add e.g. `" + std::string(example) + "`");
  }
  return value;
}

void MapReader::finish() {
  for (const YamlKey& key : node_.keys) {
    if (std::find(known_.begin(), known_.end(), key.text) != known_.end()) continue;
    report_.add(key.place,
                "unknown key '" + excerpt(path_of(key.text)) + "' (nothing would read it) " + suggestion(key.text, known_));
  }
}

}  // namespace regolab
