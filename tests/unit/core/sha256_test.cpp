#include "core/sha256.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

std::string hex(std::string_view text) {
  std::string result;
  for (const std::uint8_t byte : sha256(text)) {
    result += "0123456789abcdef"[byte / 16];
    result += "0123456789abcdef"[byte % 16];
  }
  return result;
}

// The examples of NIST for FIPS 180-4.
TEST(Sha256, IsThatOfTheStandardForThreeLetters) {
  EXPECT_EQ(hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Sha256, IsThatOfTheStandardForTwoBlocks) {
  EXPECT_EQ(hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST(Sha256, IsThatOfTheStandardForAMillionLetters) {
  EXPECT_EQ(hex(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, IsThatOfTheStandardForNothing) {
  EXPECT_EQ(hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

std::string base64_of(std::string_view text) {
  const std::string copy(text);
  return base64(std::span(reinterpret_cast<const std::uint8_t*>(copy.data()), copy.size()));
}

// RFC 4648, section 10.
TEST(Base64, PadsAsTheStandardDoes) {
  EXPECT_EQ(base64_of(""), "");
  EXPECT_EQ(base64_of("f"), "Zg==");
  EXPECT_EQ(base64_of("fo"), "Zm8=");
  EXPECT_EQ(base64_of("foo"), "Zm9v");
  EXPECT_EQ(base64_of("foobar"), "Zm9vYmFy");
}

TEST(Base64, KnowsAllDigits) {
  const std::array<std::uint8_t, 3> bytes = {0xfb, 0xff, 0xbf};

  EXPECT_EQ(base64(bytes), "+/+/");
}

}  // namespace
}  // namespace kinestat
