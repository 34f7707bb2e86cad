#include "studies/sweep/state_walk.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "plan_of.hpp"

namespace kinestat {

namespace {

// p, q, r of every state that is analysed.
std::vector<std::array<double, 3>> states_of(const SweepPlan& plan,
                                             std::uint64_t begin,
                                             std::uint64_t end) {
  std::vector<std::array<double, 3>> states;
  StateWalk walk(plan, begin, end);
  while (walk.next()) {
    const std::vector<Quantity>& values = walk.slots().values;
    states.push_back({values[0].value, values[1].value, values[2].value});
  }
  return states;
}

// Likewise, five states at a time where they are alike: these differ in the value of r alone.
std::vector<std::array<double, 3>> states_in_groups(const SweepPlan& plan,
                                                    std::uint64_t begin,
                                                    std::uint64_t end) {
  constexpr std::uint64_t kMost = 4;
  std::vector<std::array<double, 3>> states;
  StateWalk walk(plan, begin, end);
  while (walk.next()) {
    const std::uint64_t count = std::min(walk.alike(), kMost);
    const std::vector<Quantity> values = walk.slots().values;
    const std::uint64_t place = walk.places().back();
    for (std::uint64_t i = 0; i <= count; ++i) {
      states.push_back({values[0].value, values[1].value, plan.axes().back().number_at(place + i)});
    }
    walk.pass(count);
    EXPECT_EQ(walk.slots().values[2].value, states.back()[2]);
  }
  return states;
}

TEST(StateWalk, PassesOverAlikeStatesAsOneByOne) {
  const SweepPlan plan = plan_of(
      "{vary: {p: {from: 1, to: 5, step: 1}, r: {from: 1, to: 12, step: 1}}, require: [q != 4]}");

  for (std::uint64_t begin = 0; begin <= plan.state_count(); ++begin) {
    SCOPED_TRACE(begin);
    const std::uint64_t end = plan.state_count() - begin % 7;
    ASSERT_EQ(states_in_groups(plan, begin, std::max(begin, end)),
              states_of(plan, begin, std::max(begin, end)));
  }
  StateWalk walk(plan, 3, plan.state_count());
  ASSERT_TRUE(walk.next());
  EXPECT_EQ(walk.alike(), 8U);
}

TEST(StateWalk, FindsNoAlikeStatesWhereMoreHangsOnTheLastParameter) {
  for (const char* const sweep : {"{vary: {r: [1, 2, 3], p: [1, 2, 3]}}",
                                  "{vary: {p: [1, 2, 3], r: [1, 2, 3]}, require: [r != 2]}"}) {
    SCOPED_TRACE(sweep);
    const SweepPlan plan = plan_of(sweep);
    StateWalk walk(plan, 0, plan.state_count());

    ASSERT_TRUE(walk.next());
    EXPECT_EQ(walk.alike(), 0U);
  }
}

TEST(StateWalk, TurnsTheLastParameterFastest) {
  const SweepPlan plan = plan_of("{vary: {r: [5, 6], p: [1, 2]}}");

  EXPECT_EQ(states_of(plan, 0, plan.state_count()),
            (std::vector<std::array<double, 3>>{{1, 2, 5}, {2, 4, 5}, {1, 2, 6}, {2, 4, 6}}));
}

TEST(StateWalk, GivesPartsThatJoinToTheWhole) {
  const SweepPlan plan = plan_of(
      "{vary: {p: {from: 1, to: 9, step: 1}, r: {from: 1, to: 7, step: 1}}, "
      "require: [p != 4, q + r > 5, \"mod(p + r, 3) != 0\"]}");
  const auto whole = states_of(plan, 0, plan.state_count());

  for (std::uint64_t cut = 0; cut <= plan.state_count(); ++cut) {
    SCOPED_TRACE(cut);
    auto parts = states_of(plan, 0, cut);
    const auto rest = states_of(plan, cut, plan.state_count());
    parts.insert(parts.end(), rest.begin(), rest.end());
    ASSERT_EQ(parts, whole);
  }
}

TEST(StateWalk, CountsAStateForTheFirstRequirementThatItViolates) {
  const SweepPlan plan = plan_of(
      "{vary: {p: {from: 1, to: 10, step: 1}, r: {from: 1, to: 10, step: 1}}, "
      "require: [r > 2, p > 4, q + r > 15]}");
  StateWalk walk(plan, 0, plan.state_count());
  std::uint64_t analysed = 0;
  while (walk.next()) {
    ++analysed;
  }

  // Row by row: r <= 2 are 20; of the other 80, p <= 4 are 32; of 48, 2 p + r <= 15 are those of
  // p = 5 with r = 3, 4, 5 and of p = 6 with r = 3.
  EXPECT_EQ(std::vector<std::uint64_t>(walk.excluded().begin(), walk.excluded().end()),
            (std::vector<std::uint64_t>{20, 32, 4}));
  EXPECT_EQ(analysed, 44U);
}

TEST(StateWalk, PassesOverWhatOuterParametersExclude) {
  const SweepPlan plan = plan_of(
      "{vary: {p: {from: 1, to: 1000000, step: 1}, r: {from: 1, to: 1000000, step: 1}}, "
      "require: [p == 77777]}");
  StateWalk walk(plan, 0, plan.state_count());

  ASSERT_TRUE(walk.next());
  EXPECT_EQ(walk.state(), std::uint64_t{77776} * 1000000);
  EXPECT_EQ(walk.excluded()[0], std::uint64_t{77776} * 1000000);
}

TEST(StateWalk, SaysWhereARequirementHasNoAnswer) {
  const SweepPlan plan = plan_of("{vary: {p: [1, 2, 3]}, require: [1/(p - 2) > -5]}");
  StateWalk walk(plan, 0, plan.state_count());
  std::vector<bool> undefined;
  while (walk.next()) {
    undefined.push_back(walk.is_undefined());
  }

  EXPECT_EQ(undefined, (std::vector<bool>{false, true, false}));
}

}  // namespace

}  // namespace kinestat
