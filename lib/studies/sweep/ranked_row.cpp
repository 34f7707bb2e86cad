#include "studies/sweep/ranked_row.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace kinestat {

namespace {

// Hexadecimal, with a blank behind it.
constexpr std::size_t kDigits = 16;

// Before the text of a row: its number, its keys and how long it is.
constexpr std::size_t kNumbers = 2 + kMostCriteria;
constexpr std::size_t kHead = kNumbers * (kDigits + 1);

std::uint64_t read_number(const char* head, std::size_t which) {
  const char* const at = head + which * (kDigits + 1);
  std::uint64_t number = 0;
  std::from_chars(at, at + kDigits, number, kDigits);
  return number;
}

}  // namespace

double rank_key(double value, RankOrder order, double terms) {
  constexpr int kBits = 41;
  int exponent = 0;
  std::frexp(std::max(std::abs(value), terms), &exponent);
  const double better = order == RankOrder::largest ? value : -value;
  // Zero has one sign.
  return std::ldexp(std::nearbyint(std::ldexp(better, kBits - exponent)), exponent - kBits) + 0.0;
}

bool is_better(const RankKeys& a,
               std::uint64_t number_a,
               const RankKeys& b,
               std::uint64_t number_b) {
  return a != b ? a > b : number_a < number_b;
}

bool is_better(const RankedRow& a, const RankedRow& b) {
  return is_better(a.keys, a.number, b.keys, b.number);
}

std::string write_rows(const std::vector<RankedRow>& rows) {
  std::string text;
  for (const RankedRow& row : rows) {
    text += fmt::format("{:016x} ", row.number);
    for (const double key : row.keys) {
      text += fmt::format("{:016x} ", std::bit_cast<std::uint64_t>(key));
    }
    text += fmt::format("{:016x} ", row.text.size());
    text += row.text;
  }
  return text;
}

std::vector<RankedRow> read_rows(const std::string& text) {
  std::vector<RankedRow> rows;
  for (std::size_t begin = 0; begin < text.size();) {
    const char* const head = text.data() + begin;
    if (text.size() - begin < kHead ||
        text.size() - begin - kHead < read_number(head, kNumbers - 1)) {
      return {};
    }
    RankedRow row{.keys = {}, .number = read_number(head, 0), .text = {}};
    for (std::size_t i = 0; i < row.keys.size(); ++i) {
      row.keys[i] = std::bit_cast<double>(read_number(head, 1 + i));
    }
    row.text = text.substr(begin + kHead, read_number(head, kNumbers - 1));
    begin += kHead + row.text.size();
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace kinestat
