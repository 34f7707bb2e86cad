// Arrays of rows as files of NumPy (.npy): a header that says what the fields of a row are and how
// many rows follow, then the rows.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace kinestat {

/// A field of a row. All have eight bytes, little-endian on every machine, so that each lies where
/// its type wants it in memory.
struct NpyField {
  std::string name;
  bool is_whole = false;  ///< a whole number with sign; otherwise a double
};

/// The fields as a header has them: "[('teeth', '<i8'), ('ratio', '<f8')]".
std::string npy_dtype(std::span<const NpyField> fields);

/// The header of an array of so many rows. Its size is a multiple of 64 and does not depend on the
/// number of rows. Names beyond ASCII make it one of version 3.0, more than 64 KiB one of 2.0.
std::string npy_header(std::string_view dtype, std::uint64_t rows);

/// How all arrays of these fields begin.
std::string npy_signature(std::string_view dtype);

/// The eight bytes of a whole number, to be copied as they are.
inline std::uint64_t npy_bytes_of_whole(std::int64_t value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  if constexpr (std::endian::native == std::endian::big) {
    return __builtin_bswap64(bits);
  }
  return bits;
}

/// Those of a double. Both zeros are one, and so is every NaN: what has the same text has the same
/// bytes.
inline std::uint64_t npy_bytes(double value) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  return npy_bytes_of_whole(std::bit_cast<std::int64_t>(std::isnan(value) ? kNone : value + 0.0));
}

}  // namespace kinestat
