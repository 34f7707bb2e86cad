// Seeds in shards: each shard is one test, so that none takes long.
#pragma once

#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "property/network_case.hpp"
#include "support/random_network.hpp"

namespace kinestat {

inline constexpr int kSeedCount = 500;
inline constexpr int kShardSize = 20;

/// A shard may skip one seed of its twenty, 5 %, for geometry that is not clear.
inline constexpr int kMostSkips = 1;

class RandomNetworks : public ::testing::TestWithParam<int> {
 protected:
  /// Runs `check(network, seed)` on every clear network of the shard and asserts that hardly any
  /// was skipped.
  template <class Check>
  void for_each_network(const Check& check) {
    int count = 0;
    int skipped = 0;
    for (int i = 0; i < kShardSize; ++i) {
      const auto seed = static_cast<std::uint64_t>(GetParam() * kShardSize + i);
      const RandomNetwork network = make_random_network(seed);
      SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + to_yaml(network));
      const NetworkCase in_numbers = make_network_case(bind_network(network));
      if (HasFatalFailure()) {
        return;
      }
      const auto motion = solve_velocity(in_numbers.mechanism, in_numbers.twist_basis, {});
      const auto action = solve_action(in_numbers.mechanism, in_numbers.wrench_basis, {});
      if (!is_clear(motion.evidence) || !is_clear(action.evidence)) {
        ++skipped;
        continue;
      }
      ++count;
      check(network, in_numbers, seed);
    }
    EXPECT_EQ(count + skipped, kShardSize);
    EXPECT_LE(skipped, kMostSkips);
    RecordProperty("skipped", skipped);
  }
};

}  // namespace kinestat
