#include "input/yaml_tree.h"

#include <gtest/gtest.h>

#include "support/diagnostics.h"

namespace regolab {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing_support::at;

struct Parsed {
  std::optional<YamlNode> root;
  std::vector<Diagnostic> diagnostics;
};

Parsed parse(std::string_view text) {
  Report report("f.yaml", text);
  auto root = parse_yaml(text, report);
  return {std::move(root), report.take()};
}

TEST(YamlTree, KnowsWhereEverythingStands) {
  const Parsed parsed = parse("a: 1\nb:\n  - x y\n  - {c: 2}\n");
  ASSERT_TRUE(parsed.root);
  EXPECT_THAT(parsed.diagnostics, IsEmpty());
  ASSERT_EQ(parsed.root->keys.size(), 2u);
  EXPECT_EQ(parsed.root->keys[1].place, (Place{2, 1}));
  const YamlNode& list = parsed.root->items[1];
  ASSERT_TRUE(list.is_list());
  EXPECT_EQ(list.items[0].text, "x y");
  EXPECT_EQ(list.items[0].place, (Place{3, 5}));
  EXPECT_EQ(list.items[1].items[0].place, (Place{4, 9}));
}

TEST(YamlTree, KeepsBothOfADuplicateKeyAndSaysSo) {
  const Parsed parsed = parse("seed: 1\nbox: 2\nseed: 3\n");
  EXPECT_THAT(parsed.diagnostics, ElementsAre(at(3, 1, "duplicate key 'seed' (already given in line 1) keep one of them")));
  EXPECT_EQ(parsed.root->keys.size(), 3u);
}

TEST(YamlTree, RefusesEmptyFiles) {
  for (const char* text : {"", "\n\n", "# only a comment\n", "\xEF\xBB\xBF"}) {
    const Parsed parsed = parse(text);
    EXPECT_FALSE(parsed.root) << text;
    EXPECT_THAT(parsed.diagnostics, ElementsAre(at(0, 0, "empty file"))) << text;
  }
}

TEST(YamlTree, PointsAtTheByteThatIsNoText) {
  EXPECT_THAT(parse(std::string_view("a: 1\nb: \0x\n", 11)).diagnostics, ElementsAre(at(2, 4, "byte 0x00 at offset 8")));
  EXPECT_THAT(parse("a: \xff\n").diagnostics, ElementsAre(at(1, 4, "byte 0xff at offset 3 is not UTF-8 text")));
  EXPECT_THAT(parse("\x7f"
                    "ELF\x02")
                  .diagnostics,
              ElementsAre(at(1, 1, "not a text file")));
}

TEST(YamlTree, TakesUtf8ButNoneOfItsForgeries) {
  EXPECT_THAT(parse("a: \xC3\xA9\xE2\x82\xAC\xF0\x9F\x8C\x99\n").diagnostics, IsEmpty());
  for (const char* forged : {"\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xF0\x80\x80\x80", "\xC3"}) {
    EXPECT_EQ(first_bad_byte(forged), 0u);
  }
}

TEST(YamlTree, RefusesWhatIsNotUsedHere) {
  EXPECT_THAT(parse("a: &x 1\nb: *x\n").diagnostics, ElementsAre(at(1, 4, "anchor or alias")));
  EXPECT_THAT(parse("a: !!python/object 1\n").diagnostics, ElementsAre(at(1, 4, "tag")));
  EXPECT_THAT(parse("a: 1\n---\nb: 2\n").diagnostics, ElementsAre(at(3, 1, "a second document")));
  EXPECT_THAT(parse("? [a, b]\n: 1\n").diagnostics, ElementsAre(at(1, 3, "a key that is a list")));
}

TEST(YamlTree, SaysWhereTheSyntaxBreaks) {
  EXPECT_THAT(parse("a: [1, 2\n").diagnostics, ElementsAre(at(2, 1, "not valid YAML")));
  EXPECT_THAT(parse("a: 1\n b: 2\n").diagnostics, ElementsAre(at(2, 3, "not valid YAML")));
}

TEST(YamlTree, StopsNestingBombs) {
  const std::string braces(200, '[');
  EXPECT_THAT(parse("a: " + braces + std::string(200, ']')).diagnostics, ElementsAre(at(1, 19, "nested more than 16 deep")));
  EXPECT_FALSE(parse(std::string(1 << 19, '[')).diagnostics.empty());
  EXPECT_FALSE(parse(std::string(1 << 19, '{')).diagnostics.empty());
}

TEST(YamlTree, RefusesHugeFilesBeforeReadingThem) {
  const std::string huge(kLargestFile + 1, '#');
  EXPECT_THAT(parse(huge).diagnostics, ElementsAre(at(0, 0, "file of 1048577 bytes (the limit is 1048576)")));
}

TEST(Report, CountsWhatItDoesNotShow) {
  Report report("f.yaml", "x\n");
  for (int i = 0; i < 60; ++i) report.add({1, 1}, "bad");
  const auto shown = report.take();
  ASSERT_EQ(shown.size(), Report::kMost + 1);
  EXPECT_THAT(shown.back().text, ::testing::HasSubstr("10 more problems"));
}

TEST(ToText, PutsTheCaretUnderTheLetter) {
  EXPECT_EQ(to_text({"f.yaml", 2, 5, "problem (why) remedy", "abc: \xC3\xA9"}),
            "f.yaml:2:5: problem (why) remedy\n  abc: \xC3\xA9\n      ^");
  EXPECT_EQ(to_text({"f.yaml", 1, 8, "p", "a: \xC3\xA9\xC3\xA9 b"}), "f.yaml:1:8: p\n  a: \xC3\xA9\xC3\xA9 b\n       ^");
  EXPECT_EQ(to_text({"f.yaml", 0, 0, "empty", ""}), "f.yaml: empty");
}

TEST(ToText, ShowsThePartOfALongLineAroundTheCaret) {
  const std::string line = std::string(1000, 'a') + "X" + std::string(1000, 'b');
  const std::string text = to_text({"f", 1, 1001, "p", line});
  EXPECT_LT(text.size(), 400u);
  const std::size_t start = text.find('\n') + 1;
  const std::size_t caret_line = text.find('\n', start) + 1;
  EXPECT_EQ(text[start + (text.find('^') - caret_line)], 'X');
}

}  // namespace
}  // namespace regolab
