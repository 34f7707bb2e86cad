#include "studies/sweep/top_rows.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace kinestat {

namespace {

// Without the last twelve or so of 53 bits, which are rounding: what is the same by the formulas of
// a mechanism ties.
double without_rounding(double key) {
  constexpr int kBits = 41;
  int exponent = 0;
  const double mantissa = std::frexp(key, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(mantissa, kBits)), exponent - kBits);
}

}  // namespace

bool TopRows::is_better(const RankedRow& a, const RankedRow& b) const {
  const double key_a = without_rounding(a.key);
  const double key_b = without_rounding(b.key);
  if (key_a != key_b) {
    return (key_a > key_b) == (order_ == RankOrder::largest);
  }
  return a.number < b.number;
}

bool TopRows::accepts(double key, std::uint64_t number) const {
  return rows_.size() < count_ ||
         (count_ > 0 && is_better({.key = key, .number = number, .text = {}}, rows_.front()));
}

void TopRows::add(RankedRow row) {
  if (!accepts(row.key, row.number)) {
    return;
  }
  const auto better = [this](const RankedRow& a, const RankedRow& b) { return is_better(a, b); };
  if (rows_.size() == count_) {
    std::pop_heap(rows_.begin(), rows_.end(), better);
    rows_.pop_back();
  }
  rows_.push_back(std::move(row));
  std::push_heap(rows_.begin(), rows_.end(), better);
}

std::vector<RankedRow> TopRows::take() {
  std::vector<RankedRow> rows = std::exchange(rows_, {});
  std::ranges::sort(rows,
                    [this](const RankedRow& a, const RankedRow& b) { return is_better(a, b); });
  return rows;
}

std::string write_rows(const std::vector<RankedRow>& rows) {
  std::string text;
  for (const RankedRow& row : rows) {
    text += fmt::format(
        "{:016x} {:016x} {}", std::bit_cast<std::uint64_t>(row.key), row.number, row.text);
  }
  return text;
}

std::vector<RankedRow> read_rows(const std::string& text) {
  constexpr std::size_t kDigits = 16;
  constexpr std::size_t kHead = 2 * kDigits + 2;
  std::vector<RankedRow> rows;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string::npos || end - begin < kHead) {
      return {};
    }
    std::uint64_t key = 0;
    std::uint64_t number = 0;
    const char* const at = text.data() + begin;
    std::from_chars(at, at + kDigits, key, kDigits);
    std::from_chars(at + kDigits + 1, at + kHead - 1, number, kDigits);
    rows.push_back({.key = std::bit_cast<double>(key),
                    .number = number,
                    .text = text.substr(begin + kHead, end + 1 - begin - kHead)});
    begin = end + 1;
  }
  return rows;
}

}  // namespace kinestat
