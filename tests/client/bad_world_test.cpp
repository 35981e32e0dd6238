/// A right design in a wrong world: no server, no room, a port in use, a database from tomorrow.
#include <arpa/inet.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <fstream>

#include "tests/client/programs.h"

namespace regolab {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

class BadWorld : public Programs {
 protected:
  void SetUp() override {
    Programs::SetUp();
    write("a.yaml", good_design());
  }
};

/// A port that somebody listens on for as long as this lives.
class TakenPort {
 public:
  TakenPort() {
    fd_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in at{};
    at.sin_family = AF_INET;
    at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof at;
    EXPECT_EQ(bind(fd_, reinterpret_cast<sockaddr*>(&at), size), 0);
    EXPECT_EQ(listen(fd_, 1), 0);
    EXPECT_EQ(getsockname(fd_, reinterpret_cast<sockaddr*>(&at), &size), 0);
    port_ = ntohs(at.sin_port);
  }
  ~TakenPort() { close(fd_); }
  TakenPort(const TakenPort&) = delete;
  TakenPort& operator=(const TakenPort&) = delete;
  int port() const { return port_; }

 private:
  int fd_ = -1;
  int port_ = 0;
};

TEST_F(BadWorld, NobodyAtTheServerAddress) {
  const Ran ran = regolab("submit a.yaml --server 127.0.0.1:1");
  EXPECT_EQ(ran.code, 4);
  EXPECT_THAT(ran.err, HasSubstr("no scheduler at 127.0.0.1:1 ("));
  EXPECT_THAT(ran.err, HasSubstr("Connection refused"));
  EXPECT_THAT(ran.err, HasSubstr("regolab-scheduler --db FILE --listen 127.0.0.1:1"));
}

TEST_F(BadWorld, AnEstimateForAProfileThatIsNone) {
  const Ran ran = shell("$worker bench --profile hasty");
  EXPECT_EQ(ran.code, 2);
  EXPECT_THAT(ran.err, HasSubstr("hasty not in {quick,standard,article}"));
}

TEST_F(BadWorld, AServerAddressThatIsNone) {
  const Ran ran = regolab("status --server localhost");
  EXPECT_EQ(ran.code, 2);
  EXPECT_THAT(ran.err, HasSubstr("--server localhost (no port) write HOST:PORT"));
}

TEST_F(BadWorld, NoDatabaseYet) {
  const Ran ran = regolab("status");
  EXPECT_EQ(ran.code, 3);
  EXPECT_THAT(ran.err, HasSubstr("no database regolab.db (nothing was run here yet)"));
  EXPECT_THAT(listing(), Not(Contains("regolab.db")));
}

TEST_F(BadWorld, ADatabaseThatIsNone) {
  write("regolab.db", std::string(5000, 'x'));
  const Ran ran = regolab("status");
  EXPECT_EQ(ran.code, 3) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("regolab.db"));
  EXPECT_EQ(read("regolab.db"), std::string(5000, 'x'));
}

TEST_F(BadWorld, ANewerDatabase) {
  ASSERT_EQ(regolab("submit a.yaml").code, 0);
  {
    std::fstream file(folder() / "regolab.db", std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(60);  // user_version, big endian, in SQLite's file header
    file.write("\x00\x00\x27\x0f", 4);
  }
  const std::string before = read("regolab.db");
  const Ran ran = regolab("status");
  EXPECT_EQ(ran.code, 3) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("regolab.db"));
  EXPECT_THAT(ran.err, HasSubstr("newer"));
  EXPECT_EQ(read("regolab.db"), before);
}

TEST_F(BadWorld, AFolderThatDoesNotExist) {
  const Ran ran = regolab("run a.yaml --db nowhere/x.db");
  EXPECT_NE(ran.code, 0);
  EXPECT_THAT(ran.err, HasSubstr("nowhere"));
}

TEST_F(BadWorld, APortInUse) {
  const TakenPort taken;
  const Ran ran = shell(fmt::format("timeout 20 $scheduler --db s.db --listen 127.0.0.1:{}", taken.port()));
  EXPECT_NE(ran.code, 0);
  EXPECT_NE(ran.code, 124) << "it neither served nor ended";
  EXPECT_THAT(ran.err, HasSubstr(std::to_string(taken.port())));
}

TEST_F(BadWorld, AServerThatIsNoScheduler) {
  const TakenPort taken;  // accepts and never speaks
  const Ran ran = shell(fmt::format("timeout 60 $regolab status --server 127.0.0.1:{}", taken.port()));
  EXPECT_EQ(ran.code, 4) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr(fmt::format("no scheduler at 127.0.0.1:{} (", taken.port())));
}

TEST_F(BadWorld, AFullDiskBehindStdout) {
  const Ran ran = regolab("article check --all > /dev/full");
  EXPECT_EQ(ran.code, 1);
  EXPECT_THAT(ran.err, HasSubstr("cannot write the output (No space left on device)"));
}

/// A disk of 64 KiB needs a mount namespace of our own, and so root.
TEST_F(BadWorld, AFullDiskUnderTheDatabase) {
  if (shell("unshare -m true").code != 0) GTEST_SKIP() << "needs the right to mount";
  const Ran ran = shell(
      "mkdir small && unshare -m sh -c 'mount -t tmpfs -o size=64k none small && timeout 120 $regolab run a.yaml --db "
      "small/x.db'");
  EXPECT_NE(ran.code, 0);
  EXPECT_NE(ran.code, 124) << ran.err;
  EXPECT_TRUE(ran.err.find("disk") != std::string::npos || ran.err.find("space") != std::string::npos) << ran.err;
}

}  // namespace
}  // namespace regolab
