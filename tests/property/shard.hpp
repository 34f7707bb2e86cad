// Seeds in shards: each shard is one test, so that none takes long.
#pragma once

#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "property/network_case.hpp"
#include "support/random_network.hpp"

namespace kinestat {

/// Shards are named by their first seed. Those of small networks hold more.
inline constexpr int kShardSize = 20;
inline constexpr int kSmallShardSize = 100;
inline constexpr int kFirstSmallSeed = static_cast<int>(kFirstSmallSpatialSeed);
inline constexpr int kSeedCount = kFirstSmallSeed + 2000;

/// One seed of twenty may be skipped, 5 %, for geometry that is not clear.
inline constexpr int kSeedsPerSkip = 20;

/// Sanitizers make everything ten times slower; they see every fifth shard.
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define KINESTAT_IS_SANITIZED
#endif
#endif
#ifdef KINESTAT_IS_SANITIZED
inline constexpr int kShardStride = 5;
#else
inline constexpr int kShardStride = 1;
#endif
inline constexpr int kToNextShard = kShardSize * kShardStride;
inline constexpr int kToNextSmallShard = kSmallShardSize * kShardStride;

class RandomNetworks : public ::testing::TestWithParam<int> {
 protected:
  static int size() { return GetParam() < kFirstSmallSeed ? kShardSize : kSmallShardSize; }

  static int most_skips() { return size() / kSeedsPerSkip; }

  /// Runs `check(network, seed)` on every clear network of the shard and asserts that hardly any
  /// was skipped.
  template <class Check>
  void for_each_network(const Check& check) {
    int count = 0;
    int skipped = 0;
    for (int i = 0; i < size(); ++i) {
      const auto seed = static_cast<std::uint64_t>(GetParam() + i);
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
    EXPECT_EQ(count + skipped, size());
    EXPECT_LE(skipped, most_skips());
    RecordProperty("skipped", skipped);
  }
};

}  // namespace kinestat
