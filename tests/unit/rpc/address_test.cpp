#include "scheduler/rpc/address.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <utility>

namespace regolab {
namespace {

using testing::HasSubstr;

TEST(Address, WhatIsNoneIsSaidBeforeAnythingIsOpened) {
  for (const char* bad : {"", "nonsense", ":50551", "localhost:", "localhost:http", "localhost:70000", "localhost:-1"}) {
    const auto checked = check_address(bad);
    ASSERT_FALSE(checked.ok()) << bad;
    EXPECT_EQ(checked.error().code, Code::kInvalidArgument) << bad;
    EXPECT_THAT(checked.error().text, HasSubstr("give --listen host:port"));
  }
  EXPECT_EQ(check_address("unix:").error().code, Code::kInvalidArgument);
  EXPECT_EQ(check_address("unix:/" + std::string(200, 'x')).error().code, Code::kInvalidArgument);
  EXPECT_THAT(check_address("unix:/no/such/folder/socket").error().text, HasSubstr("no folder"));
  EXPECT_THAT(check_address("unix:/etc/passwd").error().text, HasSubstr("a file of that name exists"));
  EXPECT_FALSE(check_address("192.0.2.1:50551").ok()) << "not an address of this machine";
}

TEST(Address, GoodOnesPass) {
  for (const char* good : {"127.0.0.1:0", "0.0.0.0:0", "unix:/tmp/regolab-address-test"}) {
    const auto checked = check_address(good);
    EXPECT_TRUE(checked.ok()) << checked.error().text;
  }
}

TEST(Address, NamesAndVersionSixPassWhereTheMachineHasThem) {
  for (const auto& [host, address] : {std::pair{"localhost", "localhost:0"}, std::pair{"::1", "[::1]:0"}}) {
    addrinfo* found = nullptr;
    const bool known = getaddrinfo(host, nullptr, nullptr, &found) == 0;
    if (!known) continue;
    const int probe = socket(found->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const bool usable = probe >= 0 && bind(probe, found->ai_addr, found->ai_addrlen) == 0;
    if (probe >= 0) close(probe);
    freeaddrinfo(found);
    EXPECT_EQ(check_address(address).ok(), usable) << address;
  }
}

}  // namespace
}  // namespace regolab
