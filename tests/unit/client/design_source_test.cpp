#include "client/design_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace regolab::client {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

class DesignSourceTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = fs::temp_directory_path() / "regolab-design-XXXXXX";
    folder_ = mkdtemp(pattern.data());
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }
  Outcome read(const std::string& path) {
    diagnostics_.clear();
    Arguments arguments;
    arguments.design = path;
    arguments.profile = "quick";
    arguments.seeds = 3;
    return read_design_source(arguments, request_, diagnostics_);
  }

  fs::path folder_;
  pb::SubmitRequest request_;
  std::vector<Diagnostic> diagnostics_;
};

TEST_F(DesignSourceTest, SendsTextNameOverridesAndAnIdOfItsOwn) {
  const std::string path = write("a.yaml", "name: a\n");
  ASSERT_TRUE(read(path).ok());
  EXPECT_EQ(request_.design_yaml(), "name: a\n");
  EXPECT_EQ(request_.file_name(), path);
  EXPECT_EQ(request_.profile(), "quick");
  EXPECT_EQ(request_.seeds(), 3U);
  const std::string first = request_.request_id();
  EXPECT_EQ(first.size(), 32U);
  ASSERT_TRUE(read(path).ok());
  EXPECT_NE(request_.request_id(), first);
}

TEST_F(DesignSourceTest, AttachesTheTableTheDesignNamesRelativeToItself) {
  write("points.csv", "theta_F (deg)\n20\n");
  ASSERT_TRUE(read(write("a.yaml", "array: {table: points.csv}\n")).ok());
  EXPECT_EQ(request_.attachments().at("points.csv"), "theta_F (deg)\n20\n");
}

TEST_F(DesignSourceTest, AMissingTableIsToldAtItsPlace) {
  EXPECT_EQ(read(write("a.yaml", "name: a\narray:\n  table: nowhere.csv\n")).exit, Exit::kInvalidInput);
  ASSERT_EQ(diagnostics_.size(), 1U);
  EXPECT_EQ(diagnostics_[0].line, 3);
  EXPECT_EQ(diagnostics_[0].column, 10);
  EXPECT_THAT(diagnostics_[0].text, HasSubstr("cannot read the table"));
  EXPECT_THAT(diagnostics_[0].text, HasSubstr("No such file"));
}

TEST_F(DesignSourceTest, MissingFilesAndFoldersAreRefused) {
  EXPECT_THAT(read((folder_ / "none.yaml").string()).text, HasSubstr("No such file or directory"));
  EXPECT_THAT(read(folder_.string()).text, HasSubstr("it is a folder"));
}

TEST_F(DesignSourceTest, BinaryFilesAreRefusedHereAndNotShownOnTheTerminal) {
  EXPECT_EQ(read(write("a.yaml", std::string("name: \xff\xfe\x00 x", 10))).exit, Exit::kInvalidInput);
  ASSERT_FALSE(diagnostics_.empty());
  const std::string text = diagnostics_text(diagnostics_, false);
  EXPECT_THAT(text, HasSubstr("a.yaml"));
  EXPECT_EQ(text.find('\xff'), std::string::npos);
}

TEST_F(DesignSourceTest, TooLargeFilesAreRefused) {
  EXPECT_EQ(read(write("a.yaml", std::string(3 << 20, '#'))).exit, Exit::kInvalidInput);
  ASSERT_FALSE(diagnostics_.empty());
  EXPECT_THAT(diagnostics_[0].text, HasSubstr("file of 3145728 bytes"));
}

TEST_F(DesignSourceTest, DiagnosticsPointWithACaretAndAreCounted) {
  const std::vector<Diagnostic> two{
      {.file = "a.yaml", .line = 2, .column = 3, .text = "bad (why) fix", .source_line = "  x: 1"},
      {.file = "a.yaml", .line = 0, .column = 0, .text = "worse (why) fix", .source_line = ""}};
  EXPECT_EQ(diagnostics_text(two, false),
            "a.yaml:2:3: bad (why) fix\n    x: 1\n    ^\na.yaml: worse (why) fix\n2 problems; nothing was changed\n");
  EXPECT_THAT(diagnostics_text(two, true), HasSubstr("\x1b[1ma.yaml:2:3\x1b[0m: bad"));
}

}  // namespace
}  // namespace regolab::client
