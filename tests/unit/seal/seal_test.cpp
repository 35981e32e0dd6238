#include "seal/seal.h"

#include <gtest/gtest.h>

#include "seal/random_bytes.h"

namespace regolab {
namespace {

const std::string kKey(kKeyBytes, 'k');
const std::string kText = "cohesion = 812.35 Pa\n";

TEST(Seal, OpensUnderItsOwnKeyAndName) {
  const auto bytes = sealed(kKey, kText, "9f03");
  ASSERT_TRUE(bytes.ok());
  EXPECT_EQ(*opened(kKey, *bytes, "9f03"), kText);
  EXPECT_EQ(*opened(kKey, *sealed(kKey, "", "empty"), "empty"), "");
}

TEST(Seal, TellsNothingOfTheText) {
  const std::string bytes = *sealed(kKey, kText, "9f03");
  EXPECT_EQ(bytes.find("cohesion"), std::string::npos);
  EXPECT_NE(bytes, *sealed(kKey, kText, "9f03")) << "equal texts must not look equal";
}

TEST(Seal, DoesNotOpenUnderAnotherKeyOrName) {
  const std::string bytes = *sealed(kKey, kText, "9f03");
  EXPECT_EQ(opened(std::string(kKeyBytes, 'x'), bytes, "9f03").error().code, Code::kDataLoss);
  EXPECT_EQ(opened(kKey, bytes, "9f04").error().code, Code::kDataLoss) << "two sealed files must not change places";
  EXPECT_EQ(opened("short", bytes, "9f03").error().code, Code::kDataLoss);
  EXPECT_EQ(sealed("short", kText, "9f03").error().code, Code::kInvalidArgument);
}

TEST(Seal, NoticesEveryChangedByteAndEveryCut) {
  const std::string bytes = *sealed(kKey, kText, "9f03");
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    EXPECT_FALSE(opened(kKey, changed, "9f03").ok()) << i;
    EXPECT_FALSE(opened(kKey, bytes.substr(0, i), "9f03").ok()) << i;
  }
}

TEST(RandomBytes, DifferAndTravelAsText) {
  const auto a = random_bytes(32), b = random_bytes(32);
  ASSERT_TRUE(a.ok() && b.ok());
  EXPECT_EQ(a->size(), 32U);
  EXPECT_NE(*a, *b);
  EXPECT_EQ(hex_text(std::string("\x00\xff\x1a", 3)), "00ff1a");
  EXPECT_EQ(*bytes_of_hex(hex_text(*a)), *a);
  EXPECT_FALSE(bytes_of_hex("abc").ok());
  EXPECT_FALSE(bytes_of_hex("zz").ok());
}

}  // namespace
}  // namespace regolab
