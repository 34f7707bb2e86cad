#include "studies/sweep/sweep_axis.hpp"

#include <numbers>

#include "plan_of.hpp"

namespace kinestat {

namespace {

std::vector<double> counts_of(const SweepAxis& axis) {
  std::vector<double> counts;
  for (std::uint64_t i = 0; i < axis.size(); ++i) {
    counts.push_back(axis.count_at(i));
  }
  return counts;
}

TEST(SweepAxis, CountsTenthsAsTheyAreTyped) {
  const SweepPlan plan = plan_of("{vary: {p: {from: 0.1, to: 0.5, step: 0.1}}}");

  EXPECT_EQ(counts_of(plan.axes()[0]), (std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5}));
}

TEST(SweepAxis, StopsBeforeAnEndThatItDoesNotMeet) {
  const SweepPlan plan = plan_of("{vary: {p: {from: 1, to: 2, step: 2/3}}}");

  EXPECT_EQ(counts_of(plan.axes()[0]), (std::vector<double>{1.0, 5.0 / 3.0}));
}

TEST(SweepAxis, CountsDownwards) {
  const SweepPlan plan = plan_of("{vary: {p: {from: 3, to: -1, step: -2}}}");

  EXPECT_EQ(counts_of(plan.axes()[0]), (std::vector<double>{3.0, 1.0, -1.0}));
}

TEST(SweepAxis, HasOneValueWhereFromIsTo) {
  const SweepPlan plan = plan_of("{vary: {p: {from: 7, to: 7, step: 1}}}");

  EXPECT_EQ(counts_of(plan.axes()[0]), std::vector<double>{7.0});
}

TEST(SweepAxis, CountsInTheUnitOfTheFile) {
  const SweepPlan plan =
      plan_of("{vary: {length: {from: 1 mm, to: 1.2 mm, step: 0.1 mm}, angle: [14.5 deg, 20 deg]}}",
              "units: {length: mm, angle: deg}\n");
  const SweepAxis& length = plan.axes()[0];
  const SweepAxis& angle = plan.axes()[1];

  EXPECT_EQ(counts_of(length), (std::vector<double>{1.0, 1.1, 1.2}));
  EXPECT_EQ(length.unit(), "mm");
  EXPECT_EQ(length.value_at(2).value, 1.2 / 1000.0);
  EXPECT_EQ(counts_of(angle), (std::vector<double>{14.5, 20.0}));
  EXPECT_EQ(angle.value_at(1).value, 20.0 * std::numbers::pi / 180.0);
}

TEST(SweepAxis, KnowsWhetherAllCountsAreBareWholeNumbers) {
  const auto is_whole = [](const std::string& values, const std::string& units = "") {
    return plan_of("{vary: {p: " + values + "}}", units).axes()[0].has_whole_counts();
  };

  EXPECT_TRUE(is_whole("{from: 15, to: 40, step: 5}"));
  EXPECT_TRUE(is_whole("{from: 3, to: -3, step: -2}"));
  EXPECT_TRUE(is_whole("{from: 7, to: 7, step: 1/2}"));
  EXPECT_TRUE(is_whole("[17, 18, 25]"));
  EXPECT_FALSE(is_whole("{from: 1, to: 3, step: 1/2}"));
  EXPECT_FALSE(is_whole("{from: 1/2, to: 5/2, step: 1}"));
  EXPECT_FALSE(is_whole("[17, 18.5, 25]"));
  EXPECT_FALSE(is_whole("[1e15, 2]"));
}

TEST(SweepAxis, HasNoWholeCountsInAUnit) {
  const SweepPlan plan = plan_of("{vary: {length: {from: 1 mm, to: 3 mm, step: 1 mm}}}",
                                 "units: {length: mm, angle: deg}\n");

  EXPECT_FALSE(plan.axes()[0].has_whole_counts());
}

TEST(SweepAxis, TakesIrrationalStepsAsTheyRound) {
  const SweepPlan plan = plan_of("{vary: {p: {from: 0, to: 3*sqrt(2), step: sqrt(2)}}}");

  ASSERT_EQ(plan.axes()[0].size(), 4U);
  EXPECT_DOUBLE_EQ(plan.axes()[0].count_at(3), 3.0 * std::numbers::sqrt2);
}

}  // namespace

}  // namespace kinestat
