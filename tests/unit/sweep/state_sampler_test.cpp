#include "studies/sweep/state_sampler.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "plan_of.hpp"
#include "studies/sweep/state_walk.hpp"

namespace kinestat {
namespace {

constexpr const char* kVary =
    "vary: {p: {from: 10, to: 16, step: 1}, r: [1, 5, 25], "
    "length: {from: 2 mm, to: 10 mm}, angle: {from: 30 deg, to: -10 deg}}";

SweepPlan sample_of(const std::string& sample, const std::string& more = "") {
  return plan_of("{" + std::string(kVary) + ", sample: " + sample + more + "}");
}

std::vector<std::vector<double>> drawn_states(const SweepPlan& plan,
                                              std::uint64_t begin,
                                              std::uint64_t end) {
  std::vector<std::vector<double>> states;
  StateWalk walk(plan, begin, end);
  while (walk.next()) {
    EXPECT_EQ(walk.alike(), 0U);
    std::vector<double> numbers = {static_cast<double>(walk.state())};
    for (const Quantity& value : walk.slots().values) {
      numbers.push_back(value.value);
    }
    states.push_back(std::move(numbers));
  }
  return states;
}

std::vector<std::uint64_t> counts_on(const SweepPlan& plan, std::size_t axis, std::uint64_t parts) {
  std::vector<std::uint64_t> counts(parts, 0);
  const std::uint64_t each = plan.axes()[axis].size() / parts;
  for (std::uint64_t state = 0; state < plan.state_count(); ++state) {
    ++counts[plan.place_of(state, axis) / each];
  }
  return counts;
}

TEST(StateSampler, LiesOnTheAxes) {
  for (const std::string method : {"sobol", "random", "latin"}) {
    const SweepPlan plan = sample_of("{count: 1000, method: " + method + "}");
    EXPECT_EQ(plan.state_count(), 1000U);
    for (const SweepAxis& axis : plan.axes()) {
      const auto a = static_cast<std::size_t>(&axis - plan.axes().data());
      const auto [least, most] = axis.bounds();
      std::set<std::uint64_t> places;
      for (std::uint64_t state = 0; state < plan.state_count(); ++state) {
        const std::uint64_t place = plan.place_of(state, a);
        ASSERT_LT(place, axis.size());
        ASSERT_GE(axis.number_at(place), least);
        ASSERT_LE(axis.number_at(place), most);
        places.insert(place);
      }
      EXPECT_EQ(places.size(), axis.is_interval() ? 1000U : axis.size()) << method;
    }
  }
}

TEST(StateSampler, ReachesFromEndToEndOfARange) {
  const SweepPlan plan = sample_of("{count: 1}");
  const SweepAxis& length = plan.axes()[2];
  const SweepAxis& angle = plan.axes()[3];

  EXPECT_EQ(length.number_at(0), 0.002);
  EXPECT_DOUBLE_EQ(length.number_at(length.size() / 4), 0.004);
  EXPECT_EQ(length.number_at(length.size()), 0.010);
  EXPECT_GT(angle.number_at(0), angle.number_at(1ULL << 52U));
  EXPECT_EQ(angle.bounds().second, angle.number_at(0));
}

TEST(StateSampler, OfLatinHasAStateInEachPart) {
  for (const int count : {1, 2, 3, 64, 1000}) {
    const SweepPlan plan = sample_of("{count: " + std::to_string(count) + ", method: latin}");
    // In doubles the parts of a thousand end between two places.
    std::vector<int> hits(static_cast<std::size_t>(count), 0);
    for (std::uint64_t state = 0; state < plan.state_count(); ++state) {
      ++hits[plan.place_of(state, 2) * plan.state_count() / (1ULL << 53U)];
    }
    EXPECT_EQ(hits, std::vector(static_cast<std::size_t>(count), 1));
    for (const std::size_t axis : {0U, 1U}) {
      const auto values = plan.axes()[axis].size();
      for (const std::uint64_t hit : counts_on(plan, axis, values)) {
        EXPECT_GE(hit, plan.state_count() / values);
        EXPECT_LE(hit, (plan.state_count() + values - 1) / values);
      }
    }
  }
}

TEST(StateSampler, OfSobolFallsEvenlyOnHalvesOfHalves) {
  const SweepPlan plan = sample_of("{count: 256, method: sobol, seed: 77}");

  EXPECT_EQ(counts_on(plan, 2, 256), std::vector<std::uint64_t>(256, 1));
  EXPECT_EQ(counts_on(plan, 3, 32), std::vector<std::uint64_t>(32, 8));
}

TEST(StateSampler, IsTheSameWhereverTheWalkBegins) {
  for (const std::string method : {"sobol", "random", "latin"}) {
    const SweepPlan plan =
        sample_of("{count: 90, method: " + method + "}", ", require: [p != 12, q > 2*r]");
    const auto whole = drawn_states(plan, 0, 90);
    EXPECT_LT(whole.size(), 80U);
    for (std::uint64_t cut = 0; cut <= 90; ++cut) {
      auto joined = drawn_states(plan, 0, cut);
      const auto rest = drawn_states(plan, cut, 90);
      joined.insert(joined.end(), rest.begin(), rest.end());
      EXPECT_EQ(joined, whole);
    }
  }
}

TEST(StateSampler, ExcludesEachDrawByItself) {
  const SweepPlan plan = sample_of("{count: 500, method: random}", ", require: [p != 12, r < 25]");
  StateWalk walk(plan, 0, 500);
  std::uint64_t kept = 0;
  while (walk.next()) {
    ++kept;
    EXPECT_NE(walk.slots().values[0].value, 12.0);
  }
  std::uint64_t of_first = 0;
  std::uint64_t of_second = 0;
  for (std::uint64_t state = 0; state < 500; ++state) {
    const bool is_first = plan.place_of(state, 0) == 2;
    of_first += is_first ? 1U : 0U;
    of_second += !is_first && plan.place_of(state, 1) == 2 ? 1U : 0U;
  }

  EXPECT_EQ(walk.excluded()[0], of_first);
  EXPECT_EQ(walk.excluded()[1], of_second);
  EXPECT_EQ(kept, 500 - of_first - of_second);
}

TEST(StateSampler, FollowsItsSeed) {
  for (const std::string method : {"sobol", "random", "latin"}) {
    const auto states = [&](const std::string& seed) {
      return drawn_states(sample_of("{count: 20, method: " + method + seed + "}"), 0, 20);
    };
    EXPECT_EQ(states(""), states(", seed: 1"));
    EXPECT_NE(states(""), states(", seed: 2"));
  }
}

TEST(SweepPlan, OfRowsHasNoSample) {
  SweepPlan plan = sample_of("{count: 20}");
  const std::vector<double> rows = {11, 1, 3, 4, 12, 5, 6, 7};
  plan.run_through(rows);

  ASSERT_EQ(plan.state_count(), 2U);
  EXPECT_EQ(plan.axes()[2].count_at(plan.place_of(1, 2)), 6.0);
}

}  // namespace
}  // namespace kinestat
