#include "report/npy.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace kinestat {

namespace {

constexpr std::size_t kAlignment = 64;
constexpr std::size_t kMostDigits = std::numeric_limits<std::uint64_t>::digits10 + 1;
constexpr std::string_view kBehindRows = ",), }";

// A literal of Python, which is what a header is read as.
std::string python_text(std::string_view name) {
  std::string text = "'";
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\\' || c == '\'') {
      text += '\\';
      text += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      text += fmt::format("\\x{:02x}", byte);
    } else {
      text += c;
    }
  }
  return text + "'";
}

// What stands before the dictionary, and how long that is with the spaces behind it.
struct Frame {
  std::string beginning;
  std::size_t size = 0;
};

Frame frame_of(std::string_view dictionary_to_rows, bool is_ascii) {
  const std::size_t text = dictionary_to_rows.size() + kMostDigits + kBehindRows.size() + 1;
  const auto padded = [&](std::size_t before) {
    return (before + text + kAlignment - 1) / kAlignment * kAlignment - before;
  };
  constexpr std::size_t kShort = 10;  // magic, version, two bytes for the size
  constexpr std::size_t kLong = 12;
  const bool is_short = is_ascii && padded(kShort) <= std::numeric_limits<std::uint16_t>::max();
  const std::size_t size = padded(is_short ? kShort : kLong);
  std::string beginning = "\x93NUMPY";
  beginning += is_short ? '\x01' : is_ascii ? '\x02' : '\x03';
  beginning += '\0';
  for (std::size_t i = 0; i < (is_short ? 2U : 4U); ++i) {
    beginning += static_cast<char>(size >> (8 * i) & 0xffU);
  }
  return {.beginning = std::move(beginning), .size = size};
}

struct Signed {
  std::string text;      ///< up to the number of rows
  std::size_t size = 0;  ///< of the whole header
};

Signed signature_of(std::string_view dtype) {
  const bool is_ascii =
      std::ranges::all_of(dtype, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  const std::string dictionary =
      fmt::format("{{'descr': {}, 'fortran_order': False, 'shape': (", dtype);
  const Frame frame = frame_of(dictionary, is_ascii);
  return {.text = frame.beginning + dictionary, .size = frame.beginning.size() + frame.size};
}

}  // namespace

std::string npy_dtype(std::span<const NpyField> fields) {
  std::string text = "[";
  for (const NpyField& field : fields) {
    text += fmt::format("{}({}, '{}')",
                        text.size() > 1 ? ", " : "",
                        python_text(field.name),
                        field.is_whole ? "<i8" : "<f8");
  }
  return text + "]";
}

std::string npy_header(std::string_view dtype, std::uint64_t rows) {
  const Signed signature = signature_of(dtype);
  std::string text = fmt::format("{}{}{}", signature.text, rows, kBehindRows);
  text.resize(signature.size - 1, ' ');
  return text + "\n";
}

std::string npy_signature(std::string_view dtype) {
  return signature_of(dtype).text;
}

}  // namespace kinestat
