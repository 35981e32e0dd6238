#include "store/artifact_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support/temp_dir.h"

namespace regolab {
namespace {

struct ArtifactFilesTest : testing::Test {
  test::TempDir dir;
  ArtifactFiles files = std::move(ArtifactFiles::open(dir / "lab.db.d")).value();
  std::string bytes = std::string(300'000, 'x') + "end";
  std::string digest = sha256_hex(bytes);

  void put() {
    auto upload = files.begin(digest);
    ASSERT_TRUE(upload.ok());
    ASSERT_TRUE(upload->add(bytes).ok());
    ASSERT_TRUE(upload->finish().ok());
  }
  std::string file() { return dir / ("lab.db.d/cas/" + digest.substr(0, 2) + "/" + digest.substr(2)); }
};

TEST_F(ArtifactFilesTest, WhatWentInComesOut) {
  put();
  EXPECT_TRUE(files.has(digest));
  EXPECT_EQ(*files.read(digest), bytes);
  put();  // the same bytes again are no error
  EXPECT_EQ(files.list(), std::vector{digest});
}

TEST_F(ArtifactFilesTest, WrongBytesNeverGetAName) {
  auto upload = files.begin(digest);
  ASSERT_TRUE(upload->add("something else").ok());
  const auto finished = upload->finish();
  ASSERT_FALSE(finished.ok());
  EXPECT_EQ(finished.error().code, Code::kDataLoss);
  EXPECT_FALSE(files.has(digest));
}

TEST_F(ArtifactFilesTest, AnUnfinishedUploadLeavesNothing) {
  {
    auto upload = files.begin(digest);
    ASSERT_TRUE(upload->add(bytes).ok());
  }
  EXPECT_TRUE(std::filesystem::is_empty(dir / "lab.db.d/incoming"));
  EXPECT_EQ(files.read(digest).error().code, Code::kNotFound);
}

TEST_F(ArtifactFilesTest, OneChangedByteIsFoundAndSetAside) {
  put();
  {
    std::fstream damaged{file(), std::ios::in | std::ios::out | std::ios::binary};
    damaged.seekp(150'000);
    damaged.put('y');
  }
  EXPECT_EQ(files.read(digest).error().code, Code::kDataLoss);
  EXPECT_FALSE(files.has(digest));
  put();
  EXPECT_EQ(*files.read(digest), bytes);
}

TEST_F(ArtifactFilesTest, ATruncatedFileIsFound) {
  put();
  std::filesystem::resize_file(file(), 10);
  EXPECT_EQ(files.read(digest).error().code, Code::kDataLoss);
}

TEST_F(ArtifactFilesTest, ADigestIsNoWayOutOfTheFolder) {
  EXPECT_EQ(files.begin("../../../../etc/passwd").error().code, Code::kInvalidArgument);
  EXPECT_EQ(files.read("..").error().code, Code::kInvalidArgument);
}

}  // namespace
}  // namespace regolab
