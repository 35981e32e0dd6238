/// What a confined process can still do. In a child, for rights that are given up do not come back.
#include "scheduler/solver/confinement.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <string>

namespace regolab {
namespace {

constexpr int kNothing = 100;  // exit code: it could

/// errno of `attempt` in a confined child; kNothing when it got through.
template <class Attempt>
int tried(const Walls& walls, const Attempt& attempt) {
  const pid_t child = fork();
  if (child == 0) {
    confine(walls);
    errno = 0;
    _exit(attempt() ? kNothing : errno);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

class Confinement : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = ::testing::TempDir() + "truth-XXXXXX";
    const int fd = mkstemp(pattern.data());
    ASSERT_GE(fd, 0);
    ASSERT_EQ(write(fd, "cohesion", 8), 8);
    close(fd);
    secret_ = pattern;
  }
  void TearDown() override { unlink(secret_.c_str()); }
  bool can_read() const { return open(secret_.c_str(), O_RDONLY) >= 0; }

  std::string secret_;
};

TEST_F(Confinement, WithoutItTheFileCanBeRead) {
  EXPECT_EQ(tried({.landlock = false, .descriptors = false}, [&] { return can_read(); }), kNothing);
}

TEST_F(Confinement, LandlockDeniesAFileThatWasNotHandedOver) {
  if (landlock_version() < 1) GTEST_SKIP() << "this kernel has no Landlock";
  const Walls landlock{.landlock = true, .descriptors = false};
  EXPECT_EQ(tried(landlock, [&] { return can_read(); }), EACCES);
  EXPECT_EQ(tried(landlock, [&] { return open("/", O_RDONLY | O_DIRECTORY) >= 0; }), EACCES);
  EXPECT_EQ(tried(landlock, [&] { return open((secret_ + ".new").c_str(), O_WRONLY | O_CREAT, 0600) >= 0; }), EACCES);
  EXPECT_EQ(tried(landlock, [&] { return unlink(secret_.c_str()) == 0; }), EACCES);
}

TEST_F(Confinement, LandlockDeniesTheNetwork) {
  if (landlock_version() < 4) GTEST_SKIP() << "this kernel's Landlock knows no network";
  const auto dial = [] {
    sockaddr_in to{};
    to.sin_family = AF_INET, to.sin_port = htons(9), to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return connect(socket(AF_INET, SOCK_STREAM, 0), reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0;
  };
  EXPECT_EQ(tried({.landlock = true, .descriptors = false}, dial), EACCES);
}

TEST_F(Confinement, NoNewDescriptorsHoldsOnAnyKernel) {
  EXPECT_EQ(tried({.landlock = false, .descriptors = true}, [&] { return can_read(); }), EMFILE);
}

TEST_F(Confinement, WhatWasInheritedIsClosed) {
  const int inherited = open(secret_.c_str(), O_RDONLY);
  ASSERT_GE(inherited, 3);
  char byte = 0;
  EXPECT_EQ(tried({.landlock = false, .descriptors = true}, [&] { return read(inherited, &byte, 1) == 1; }), EBADF);
  close(inherited);
}

TEST_F(Confinement, SaysWhatHolds) {
  EXPECT_EQ(confine({.landlock = false, .descriptors = false}), "none (not asked for)");
  EXPECT_EQ(tried({.landlock = false, .descriptors = false}, [] { return confine({}).find("no new descriptors") != std::string::npos; }), kNothing);
}

}  // namespace
}  // namespace regolab
