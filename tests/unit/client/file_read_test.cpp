#include "client/file_read.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace regolab::client {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

struct FileRead : ::testing::Test {
  fs::path path = fs::temp_directory_path() / ("file-read-" + std::to_string(::getpid()));
  ~FileRead() override { fs::remove(path); }
};

TEST_F(FileRead, AFileOfAGigabyteIsRefusedByItsSize) {
  std::ofstream(path) << "format: observations/1\n";
  fs::resize_file(path, 1U << 30);  // sparse: nothing of it is on the disk, and nothing may be read
  std::string text;
  const Outcome outcome = read_whole_file(path, 16 << 20, "an observation file", text);
  EXPECT_EQ(outcome.exit, Exit::kInvalidInput);
  EXPECT_THAT(outcome.text, HasSubstr("1073741824 bytes (the limit is 16 MiB"));
  EXPECT_TRUE(text.empty());
}

TEST_F(FileRead, AStreamWithoutEndIsReadUpToTheLimit) {
  std::string text;
  EXPECT_THAT(read_whole_file("/dev/zero", 1000, "an observation file", text).text, HasSubstr("more than 1000 bytes"));
}

TEST_F(FileRead, WhatCannotBeReadSaysWhy) {
  std::string text;
  EXPECT_THAT(read_whole_file(path / "none", 1000, "an observation file", text).text, HasSubstr("No such file"));
  EXPECT_THAT(read_whole_file(fs::temp_directory_path(), 1000, "an observation file", text).text, HasSubstr("it is a folder"));
  std::ofstream(path) << "x";
  EXPECT_TRUE(read_whole_file(path, 1, "a letter", text).ok());
  EXPECT_EQ(text, "x");
}

}  // namespace
}  // namespace regolab::client
