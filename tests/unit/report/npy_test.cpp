#include "report/npy.hpp"

#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

// What the specification of the format says of the bytes before the dictionary.
struct Header {
  int version = 0;
  std::size_t before = 0;  // the dictionary
  std::size_t size = 0;    // of the dictionary with the spaces and the line end behind it
};

Header read(const std::string& text) {
  const auto byte = [&](std::size_t at) {
    return static_cast<std::size_t>(static_cast<unsigned char>(text.at(at)));
  };
  EXPECT_EQ(text.substr(0, 6), "\x93NUMPY");
  EXPECT_EQ(byte(7), 0U);
  Header header{.version = static_cast<int>(byte(6)), .before = 0, .size = byte(8) + 256 * byte(9)};
  header.before = header.version == 1 ? 10 : 12;
  if (header.version > 1) {
    header.size += 65536 * byte(10) + 16777216 * byte(11);
  }
  return header;
}

std::string dictionary_of(const std::string& text) {
  const std::string all = text.substr(read(text).before);
  return all.substr(0, all.find_last_not_of(" \n") + 1);
}

const std::vector<NpyField> kFields = {{.name = "Ns", .is_whole = true}, {.name = "C1 [N*m]"}};

TEST(NpyHeader, SaysWhatTheFieldsAreAndHowManyRowsFollow) {
  const std::string text = npy_header(npy_dtype(kFields), 1234);

  EXPECT_EQ(read(text).version, 1);
  EXPECT_EQ(dictionary_of(text),
            "{'descr': [('Ns', '<i8'), ('C1 [N*m]', '<f8')], 'fortran_order': False, "
            "'shape': (1234,), }");
}

TEST(NpyHeader, IsFilledUpTo64BytesWithSpacesAndALineEnd) {
  std::string name = "a";
  for (int more = 0; more < 130; ++more, name += 'a') {
    const NpyField field{.name = name};
    const std::string text = npy_header(npy_dtype(std::span(&field, 1)), 7);

    ASSERT_EQ(text.size() % 64, 0U);
    ASSERT_EQ(read(text).before + read(text).size, text.size());
    ASSERT_EQ(text.back(), '\n');
    ASSERT_EQ(text.find('\n'), text.size() - 1);
  }
}

TEST(NpyHeader, BeginsAndEndsInTheSamePlaceWhateverItsRows) {
  const std::string dtype = npy_dtype(kFields);
  const std::string none = npy_header(dtype, 0);
  const std::string most = npy_header(dtype, std::numeric_limits<std::uint64_t>::max());

  EXPECT_EQ(none.size(), most.size());
  EXPECT_TRUE(none.starts_with(npy_signature(dtype)));
  EXPECT_TRUE(most.starts_with(npy_signature(dtype)));
  EXPECT_TRUE(dictionary_of(most).ends_with("'shape': (18446744073709551615,), }"));
}

TEST(NpyHeader, QuotesNamesAsPythonDoes) {
  const NpyField field{.name = "a'b\\c\nd\x7f"};
  EXPECT_EQ(npy_dtype(std::span(&field, 1)), R"([('a\'b\\c\x0ad\x7f', '<f8')])");
}

TEST(NpyHeader, OfNamesBeyondAsciiIsUtf8AndOfVersion3) {
  const NpyField field{.name = "\xce\xb1 [\xc2\xb5m]"};
  const std::string text = npy_header(npy_dtype(std::span(&field, 1)), 7);

  EXPECT_EQ(read(text).version, 3);
  EXPECT_EQ(text.size() % 64, 0U);
  EXPECT_EQ(read(text).before + read(text).size, text.size());
  EXPECT_NE(text.find("('\xce\xb1 [\xc2\xb5m]', '<f8')"), std::string::npos);
}

TEST(NpyHeader, BeyondSixteenBitsIsOfVersion2) {
  const std::vector<NpyField> fields(6000, NpyField{.name = "torque"});
  const std::string text = npy_header(npy_dtype(fields), 7);

  EXPECT_EQ(read(text).version, 2);
  EXPECT_EQ(text.size() % 64, 0U);
  EXPECT_EQ(read(text).before + read(text).size, text.size());
}

TEST(NpyBytes, AreLittleEndian) {
  const std::uint64_t whole = npy_bytes_of_whole(-2);
  const std::uint64_t number = npy_bytes(1.0);  // 0x3ff0000000000000

  EXPECT_EQ(std::memcmp(&whole, "\xfe\xff\xff\xff\xff\xff\xff\xff", 8), 0);
  EXPECT_EQ(std::memcmp(&number, "\0\0\0\0\0\0\xf0\x3f", 8), 0);
}

TEST(NpyBytes, HaveOneZeroAndOneNaN) {
  using Limits = std::numeric_limits<double>;
  EXPECT_EQ(npy_bytes(-0.0), npy_bytes(0.0));
  EXPECT_EQ(npy_bytes(0.0), 0U);
  EXPECT_EQ(npy_bytes(-Limits::quiet_NaN()), npy_bytes(Limits::signaling_NaN()));
  EXPECT_NE(npy_bytes(Limits::denorm_min()), npy_bytes(0.0));
}

}  // namespace
}  // namespace kinestat
