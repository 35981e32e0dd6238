#include "worker/output/atomic_file.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>

#include "unit/output/temporary_folder.h"

namespace regolab {
namespace {

using test::TemporaryFolder;
using ::testing::HasSubstr;

/// While it lives, no file may grow beyond `bytes`: writing fails as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST(WriteWholeFile, IsReadBackByteForByteAndLeavesNothingElse) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\n\xff", 5);
  ASSERT_TRUE(write_whole_file(folder / "x", "longer than what follows").ok());
  ASSERT_TRUE(write_whole_file(folder / "x", bytes).ok());
  EXPECT_EQ(*read_whole_file(folder / "x"), bytes);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(WriteWholeFile, OnAFullDiskSaysSoAndLeavesTheOldFileWhole) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_whole_file(folder / "x", "old").ok());
  Result<void> written;
  {
    const FullDisk full(1000);
    written = write_whole_file(folder / "x", std::string(5000, 'n'));
  }
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().code, Code::kResourceExhausted);
  EXPECT_THAT(written.error().text, HasSubstr("free some space"));
  EXPECT_EQ(*read_whole_file(folder / "x"), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1) << "the part file stayed";
}

TEST(WriteWholeFile, BelowAFileIsRefusedByName) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_whole_file(folder / "file", "x").ok());
  const auto written = write_whole_file(folder / "file/below", "y");
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().code, Code::kFailedPrecondition);
  EXPECT_THAT(written.error().text, HasSubstr("file/below: cannot be written"));
}

TEST(ReadWholeFile, TellsAMissingFileFromAFolder) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_whole_file(folder / "nothing").error().code, Code::kNotFound);
  EXPECT_THAT(read_whole_file(folder.path()).error().text, HasSubstr("it is a folder"));
}

TEST(MakeWritableFolder, MakesParentsAndRefusesAFile) {
  const TemporaryFolder folder;
  EXPECT_TRUE(make_writable_folder(folder / "a/b/c").ok());
  EXPECT_TRUE(std::filesystem::is_empty(folder / "a/b/c"));
  ASSERT_TRUE(write_whole_file(folder / "file", "x").ok());
  EXPECT_EQ(make_writable_folder(folder / "file").error().code, Code::kFailedPrecondition);
}

}  // namespace
}  // namespace regolab
