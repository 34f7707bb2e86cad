#include "core/exact_text.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <dragonbox/dragonbox.h>
#include <string_view>

#include "core/contract.hpp"
#include "core/index.hpp"

namespace kinestat {
namespace {

constexpr int kMostDigits = 17;       // of the shortest decimal of a double
constexpr int kMostWholeDigits = 16;  // 1e16 and more are written with an exponent
constexpr int kMostZeros = 3;         // behind the point, before the first digit: 0.0001
constexpr int kBlock = 16;            // characters copied at once, needed or not

constexpr auto kPowersOfTen = [] {
  std::array<std::uint64_t, kMostDigits + 1> powers = {1};
  for (std::size_t i = 1; i < powers.size(); ++i) {
    powers[i] = 10 * powers[i - 1];
  }
  return powers;
}();

constexpr auto kPairs = [] {  // "000102" to "9899"
  std::array<char, 200> pairs = {};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::size_t pair = i / 2;
    pairs[i] = static_cast<char>('0' + (i % 2 == 0 ? pair / 10 : pair % 10));
  }
  return pairs;
}();

void write_pair(std::uint32_t pair, char* text) {
  std::memcpy(text, &kPairs[2 * pair], 2);
}

void write_eight_digits(std::uint32_t number, char* text) {
  const std::uint32_t first = number / 10'000;
  const std::uint32_t last = number % 10'000;
  write_pair(first / 100, text);
  write_pair(first % 100, text + 2);
  write_pair(last / 100, text + 4);
  write_pair(last % 100, text + 6);
}

int count_digits(std::uint64_t number) {
  const int bits = static_cast<int>(std::bit_width(number));
  const int at_most = (bits * 1233) >> 12;  // 1233 / 4096 is about lg 2
  return at_most + (number >= kPowersOfTen[at(at_most)] ? 1 : 0);
}

char* write_exponent(int exponent, char* text) {
  *text++ = 'e';
  *text++ = exponent < 0 ? '-' : '+';
  const auto size = static_cast<std::uint32_t>(std::abs(exponent));
  if (size >= 100) {
    *text++ = static_cast<char>('0' + size / 100);
  }
  write_pair(size % 100, text);
  return text + 2;
}

}  // namespace

// Where a copy is longer than what is needed, its length is the same for every number: a processor
// that cannot foresee how many digits come waits longer for that than the copy takes.
char* write_exact(double value, char* text) {
  KINESTAT_EXPECTS(std::isfinite(value));
  if (value == 0.0) {
    return std::ranges::copy(std::string_view("0.0"), text).out;
  }
  const auto decimal = jkj::dragonbox::to_decimal(value);
  *text = '-';
  text += decimal.is_negative ? 1 : 0;

  const int count = count_digits(decimal.significand);
  const int whole = count + decimal.exponent;  // digits before the point
  const std::uint64_t filled = decimal.significand * kPowersOfTen[at(kMostDigits - count)];
  char digits[2 * kBlock] = {};
  const auto last = static_cast<std::uint32_t>(filled % 1'000'000'000);
  write_eight_digits(static_cast<std::uint32_t>(filled / 1'000'000'000), digits);
  write_eight_digits(last / 10, digits + 8);
  digits[kMostDigits - 1] = static_cast<char>('0' + last % 10);

  if (whole > 0 && whole < count) {
    std::memcpy(text, digits, kBlock);
    text[whole] = '.';
    std::memcpy(text + whole + 1, digits + whole, kBlock);
    return text + count + 1;
  }
  if (whole > kMostWholeDigits || whole < -kMostZeros) {
    text[0] = digits[0];
    text[1] = '.';
    std::memcpy(text + 2, digits + 1, kBlock);
    return write_exponent(whole - 1, count == 1 ? text + 1 : text + count + 1);
  }
  if (whole <= 0) {
    std::memcpy(text, "0.000", 5);
    std::memcpy(text + 2 - whole, digits, kMostDigits);
    return text + 2 - whole + count;
  }
  std::memcpy(text, digits, kBlock);  // zeros follow the last digit
  std::memcpy(text + whole, ".0", 2);
  return text + whole + 2;
}

void append_exact(double value, std::string& text) {
  char digits[kRoomForExact];
  text.append(&digits[0], write_exact(value, &digits[0]));
}

}  // namespace kinestat
