#include "studies/transmissions/set_minors.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace kinestat {

namespace {

using Columns = std::array<Shaft, kMostGearSets>;

// Whether sorting the columns takes an odd number of exchanges; they are different.
bool is_odd(const Columns& columns, int count) {
  bool odd = false;
  for (int i = 0; i < count; ++i) {
    for (int j = i + 1; j < count; ++j) {
      odd ^= columns[static_cast<std::size_t>(i)] > columns[static_cast<std::size_t>(j)];
    }
  }
  return odd;
}

std::uint32_t bits_of(const Columns& columns, int count) {
  std::uint32_t bits = 0;
  for (int i = 0; i < count; ++i) {
    bits |= 1U << columns[static_cast<std::size_t>(i)];
  }
  return bits;
}

}  // namespace

std::optional<MergedShafts> MergedShafts::merge(int shafts, std::span<const ShaftPair> joined) {
  std::array<Shaft, kMostShafts> first{};  // of each shaft the least that it turns with
  for (int i = 0; i < shafts; ++i) {
    first[static_cast<std::size_t>(i)] = static_cast<Shaft>(i);
  }
  for (const ShaftPair& pair : joined) {
    const auto [low, high] = std::minmax({first[pair[0]], first[pair[1]]});
    if (low == high) {
      return std::nullopt;
    }
    std::ranges::replace(first, high, low);
  }
  MergedShafts merged;
  merged.shafts_ = shafts;
  for (int i = 0; i < shafts; ++i) {
    const auto shaft = static_cast<std::size_t>(i);
    merged.group_[shaft] = first[shaft] == i ? merged.count_++ : merged.group_[first[shaft]];
  }
  return merged;
}

SetMinors::SetMinors(const TransmissionStructure& structure)
    : sets_(structure.set_count()),
      minor_of_(std::size_t{1} << static_cast<unsigned>(structure.shafts), kNoMinor) {
  std::size_t product_count = 1;
  for (int s = 0; s < sets_; ++s) {
    product_count *= 3;
  }
  for (std::size_t product = 0; product < product_count; ++product) {
    Columns columns{};
    std::size_t digits = product;
    for (auto s = static_cast<std::size_t>(sets_); s-- > 0; digits /= 3) {
      columns[s] = structure.sets[s][digits % 3];
    }
    const std::uint32_t bits = bits_of(columns, sets_);
    if ((bits & 1U << kHousing) != 0 || std::popcount(bits) != sets_) {
      continue;
    }
    std::uint8_t& minor = minor_of_[bits];
    minor = minor == kNoMinor ? static_cast<std::uint8_t>(count_++) : minor;
    products_.push_back({.product = static_cast<std::uint8_t>(product),
                         .minor = minor,
                         .is_negative = is_odd(columns, sets_)});
  }
}

std::vector<MinorTerm> SetMinors::speed_terms(const MergedShafts& merged, int group) const {
  std::vector<MinorTerm> terms;
  if (group == merged.of(kHousing) || merged.count() != sets_ + 2) {
    return terms;
  }
  std::array<std::array<Shaft, kMostShafts>, kMostGearSets> members{};
  std::array<int, kMostGearSets> sizes{};
  for (int i = 0; i < merged.shafts(); ++i) {
    const int its = merged.of(static_cast<Shaft>(i));
    if (its != 0 && its != group) {
      const auto column = static_cast<std::size_t>(its < group ? its - 1 : its - 2);
      members[column][static_cast<std::size_t>(sizes[column]++)] = static_cast<Shaft>(i);
    }
  }
  std::array<int, kMostGearSets> at{};
  while (true) {
    Columns columns{};
    for (std::size_t c = 0; c < static_cast<std::size_t>(sets_); ++c) {
      columns[c] = members[c][static_cast<std::size_t>(at[c])];
    }
    const std::uint8_t minor = minor_of_[bits_of(columns, sets_)];
    if (minor != kNoMinor) {
      terms.push_back({.minor = minor, .is_negative = is_odd(columns, sets_) != (group % 2 == 0)});
    }
    std::size_t c = 0;
    while (c < static_cast<std::size_t>(sets_) && ++at[c] == sizes[c]) {
      at[c++] = 0;
    }
    if (c == static_cast<std::size_t>(sets_)) {
      return terms;
    }
  }
}

}  // namespace kinestat
