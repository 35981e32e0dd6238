#include "input/yaml_tree.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <utility>
#include <sstream>

namespace regolab {
namespace {

Place place_of(const YAML::Mark& mark) { return {mark.line + 1, mark.column + 1}; }

/// Builds the tree from yaml-cpp's events; its own Node type would lose duplicate keys silently.
class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(Report& report, const YamlLimits& limits) : report_(report), limits_(limits) {}

  std::optional<YamlNode> take_root() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnAnchor(const YAML::Mark&, const std::string&) override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    refuse_anchor(mark, anchor);
    add({.kind = YamlNode::Kind::kNull, .place = place_of(mark)});
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    refuse_anchor(mark, 1);
    add({.kind = YamlNode::Kind::kNull, .place = place_of(mark)});
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, const std::string& value) override {
    refuse_anchor(mark, anchor);
    refuse_tag(mark, tag);
    add({.kind = YamlNode::Kind::kScalar, .place = place_of(mark), .text = value});
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, YamlNode::Kind::kList);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, YamlNode::Kind::kMap);
  }
  void OnMapEnd() override { close(); }

 private:
  void refuse_anchor(const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (anchor == YAML::NullAnchor || std::exchange(anchored_, true)) return;  // one message: a file made of them has thousands
    report_.add(place_of(mark), "anchor or alias (they are not used here) write the values out");
  }
  void refuse_tag(const YAML::Mark& mark, const std::string& tag) {
    if (tag.empty() || tag == "?" || tag == "!") return;  // yaml-cpp's marks for plain and quoted text
    report_.add(place_of(mark), "tag '" + excerpt(tag) + "' (tags are not used here) leave it out");
  }
  void open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, YamlNode::Kind kind) {
    refuse_anchor(mark, anchor);
    refuse_tag(mark, tag);
    if (++depth_ > kDeepest) {
      if (depth_ == kDeepest + 1) {
        report_.add(place_of(mark),
                    "nested more than " + std::to_string(kDeepest) + " deep (no file of ours is) remove the inner levels");
      }
      return;
    }
    open_.push_back({.kind = kind, .place = place_of(mark)});
  }
  void close() {
    if (depth_-- > kDeepest) return;
    YamlNode node = std::move(open_.back());
    open_.pop_back();
    if (node.keys.size() > node.items.size()) node.keys.resize(node.items.size());
    add(std::move(node));
  }
  void add(YamlNode node) {
    if (depth_ > kDeepest || too_many(node.place)) return;
    if (open_.empty()) {
      root_ = std::move(node);
    } else if (YamlNode& parent = open_.back(); !parent.is_map() || parent.keys.size() > parent.items.size()) {
      parent.items.push_back(std::move(node));
    } else {
      add_key(parent, node);
    }
  }
  /// The rest of a file with too many values is parsed but not kept; open maps and lists still close.
  bool too_many(Place place) {
    if (++values_ <= limits_.values || open_.empty()) return false;
    if (values_ == limits_.values + 1) {
      report_.add(place, "more than " + std::to_string(limits_.values) + " values (the limit) " + std::string(limits_.remedy));
    }
    return true;
  }
  void add_key(YamlNode& parent, const YamlNode& key) {
    if (parent.keys.size() == kMostKeys) {
      report_.add(key.place, "more than " + std::to_string(kMostKeys) + " keys in one map (the limit) remove the others");
    }
    if (parent.keys.size() >= kMostKeys) {
      parent.keys.push_back({});
      return;
    }
    if (!key.is_scalar()) {
      report_.add(key.place,
                  "a key that is " + std::string(name_of(key.kind)) + " (keys are plain names) write `name: value`");
    } else {
      const auto same = [&](const YamlKey& other) { return other.text == key.text; };
      if (const auto first = std::find_if(parent.keys.begin(), parent.keys.end(), same); first != parent.keys.end()) {
        report_.add(key.place, "duplicate key '" + excerpt(key.text) + "' (already given in line " +
                                   std::to_string(first->place.line) + ") keep one of them");
      }
    }
    parent.keys.push_back({key.text, key.place});
  }

  Report& report_;
  const YamlLimits limits_;
  std::size_t values_ = 0;
  std::vector<YamlNode> open_;
  std::optional<YamlNode> root_;
  int depth_ = 0;
  bool anchored_ = false;
};

/// Length of the UTF-8 letter at the front, 0 when it is not one.
std::size_t letter_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  if ((lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xED && byte(1) > 0x9F)) return 0;  // overlong; surrogates
  if ((lead == 0xF0 && byte(1) < 0x90) || (lead == 0xF4 && byte(1) > 0x8F)) return 0;  // overlong; beyond Unicode
  return length;
}

Place place_at(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const auto line = std::count(before.begin(), before.end(), '\n');
  const std::size_t newline = before.rfind('\n');
  const std::size_t start = newline == std::string_view::npos ? 0 : newline + 1;
  return {static_cast<int>(line) + 1, static_cast<int>(offset - start) + 1};
}

std::string hex_byte(char c) {
  constexpr char kDigits[] = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  return std::string("0x") + kDigits[byte >> 4] + kDigits[byte & 15];
}

bool check_bytes(std::string_view text, const YamlLimits& limits, Report& report) {
  if (text.size() > limits.bytes) {
    report.add({}, "file of " + std::to_string(text.size()) + " bytes (the limit is " + std::to_string(limits.bytes) + ") " +
                       std::string(limits.remedy));
    return false;
  }
  if (const auto bad = first_bad_byte(text)) {
    report.add(place_at(text, *bad), "not a text file (byte " + hex_byte(text[*bad]) + " at offset " + std::to_string(*bad) +
                                         " is not UTF-8 text) give a YAML file");
    return false;
  }
  return true;
}

}  // namespace

std::string_view name_of(YamlNode::Kind kind) {
  switch (kind) {
    case YamlNode::Kind::kNull: return "nothing";
    case YamlNode::Kind::kScalar: return "text";
    case YamlNode::Kind::kList: return "a list";
    case YamlNode::Kind::kMap: return "a map";
  }
  return "nothing";
}

std::optional<std::size_t> first_bad_byte(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    const auto byte = static_cast<unsigned char>(c);
    const bool control = (byte < 0x20 && c != '\t' && c != '\n' && c != '\r') || byte == 0x7F;
    const std::size_t length = letter_length(text.substr(i));
    if (control || length == 0) return i;
    i += length;
  }
  return std::nullopt;
}

std::optional<YamlNode> parse_yaml(std::string_view text, Report& report, const YamlLimits& limits) {
  if (!check_bytes(text, limits, report)) return std::nullopt;
  TreeBuilder builder(report, limits);
  try {
    std::istringstream stream{std::string(text)};
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(builder)) {
      report.add({}, "empty file (no YAML in it) see client/examples for a filled one");
      return std::nullopt;
    }
    auto root = builder.take_root();
    TreeBuilder rest(report, limits);
    if (parser.HandleNextDocument(rest)) {
      const auto second = rest.take_root();
      report.add(second ? second->place : Place{},
                 "a second document (one file is one document) remove the `---` and what follows");
    }
    return root;
  } catch (const YAML::Exception& e) {
    const Place place = e.mark.is_null() ? Place{} : place_of(e.mark);
    report.add(place, "not valid YAML (" + excerpt(e.msg) +
                          ") check brackets, quotes and indentation here; the file may be cut off");
    return std::nullopt;
  }
}

}  // namespace regolab
