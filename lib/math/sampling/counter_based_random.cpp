#include "math/sampling/counter_based_random.hpp"

namespace kinestat {

namespace {

std::uint32_t low(std::uint64_t word) {
  return static_cast<std::uint32_t>(word);
}

std::uint32_t high(std::uint64_t word) {
  return static_cast<std::uint32_t>(word >> 32U);
}

}  // namespace

// The constants are those of the paper, its table 2 and section 4.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key) {
  constexpr int kRounds = 10;
  for (int i = 0; i < kRounds; ++i) {
    const std::uint64_t first = std::uint64_t{0xD2511F53} * counter[0];
    const std::uint64_t second = std::uint64_t{0xCD9E8D57} * counter[2];
    counter = {high(second) ^ counter[1] ^ key[0],
               low(second),
               high(first) ^ counter[3] ^ key[1],
               low(first)};
    key[0] += 0x9E3779B9;
    key[1] += 0xBB67AE85;
  }
  return counter;
}

std::uint64_t CounterBasedRandom::at(std::uint64_t stream, std::uint64_t index) const {
  const auto words =
      philox({low(index), high(index), low(stream), high(stream)}, {low(seed_), high(seed_)});
  return std::uint64_t{words[1]} << 32U | words[0];
}

}  // namespace kinestat
