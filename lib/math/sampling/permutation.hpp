// An order of many things that is asked for place by place.
#pragma once

#include <array>
#include <cstdint>

#include "math/sampling/counter_based_random.hpp"

namespace kinestat {

/// The numbers below `size`, each once, in an order that a stream of random bits decides. None is
/// kept: a Feistel network (Luby and Rackoff 1988) maps the numbers of as many bits one to one, and
/// what leaves the range is mapped again until it is back (Black and Rogaway 2002).
class Permutation {
 public:
  Permutation(std::uint64_t size, const CounterBasedRandom& bits, std::uint64_t stream);

  /// `index` is below the size.
  std::uint64_t at(std::uint64_t index) const;

 private:
  static constexpr std::size_t kRounds = 8;  // even, so that the halves are back in their places

  std::uint64_t mapped(std::uint64_t number) const;

  std::uint64_t size_;
  unsigned low_bits_ = 0;
  unsigned high_bits_ = 0;  // as many, or one less
  std::array<std::uint64_t, kRounds> keys_ = {};
};

}  // namespace kinestat
