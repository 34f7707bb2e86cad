#include "studies/shift/shift_table.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

TableGear gear(int state, std::optional<double> ratio, std::vector<int> engaged) {
  return {.state = state, .ratio = ratio, .engaged = std::move(engaged)};
}

std::vector<int> states_of(const std::vector<TableGear>& gears) {
  std::vector<int> states;
  for (const TableGear& one : gears) {
    states.push_back(one.state);
  }
  return states;
}

TEST(ShiftTable, OrdersForwardGearsThenReverseOnesThenThoseWithoutRatio) {
  std::vector<TableGear> gears = {gear(0, -2.0, {}),
                                  gear(1, std::nullopt, {}),
                                  gear(2, 1.0, {}),
                                  gear(3, -4.0, {}),
                                  gear(4, 3.0, {})};

  sort_gears(gears, 1.0);

  EXPECT_EQ(states_of(gears), (std::vector<int>{4, 2, 3, 0, 1}));
}

TEST(ShiftTable, StepsFromTheNextLowerGear) {
  const std::vector<TableGear> gears = {gear(0, 4.0, {0}),
                                        gear(1, 2.0, {1}),
                                        gear(2, 2.0, {2}),
                                        gear(3, 1.0, {3}),
                                        gear(4, -3.0, {4})};

  const ShiftTable table = make_shift_table(gears, 1.0);

  EXPECT_FALSE(table.steps[0].has_value());
  EXPECT_EQ(table.steps[1], 2.0);
  EXPECT_EQ(table.steps[2], 2.0);
  EXPECT_EQ(table.steps[3], 2.0);
  EXPECT_FALSE(table.steps[4].has_value());
  EXPECT_EQ(table.span, 4.0);
}

// Behind one pair of gears all forward gears turn against the input.
TEST(ShiftTable, TakesForForwardWhatMostGearsAre) {
  std::vector<TableGear> gears = {
      gear(0, 3.0, {0}), gear(1, -1.0, {1}), gear(2, -2.0, {2}), gear(3, std::nullopt, {3})};

  EXPECT_EQ(find_forward_sign(gears), -1.0);
  sort_gears(gears, -1.0);
  const ShiftTable table = make_shift_table(gears, -1.0);

  EXPECT_EQ(states_of(gears), (std::vector<int>{2, 1, 0, 3}));
  EXPECT_EQ(table.steps[1], 2.0);
  EXPECT_FALSE(table.steps[2].has_value());
  EXPECT_EQ(table.span, 2.0);
  EXPECT_EQ(find_forward_sign(std::vector{gear(0, 3.0, {}), gear(1, -3.0, {})}), 1.0);
}

TEST(ShiftTable, ListsEqualRatiosTogetherWhateverTheirRounding) {
  const std::vector<TableGear> gears = {
      gear(0, 2.0, {0}), gear(1, 1.0 + 1e-15, {1}), gear(2, 1.0, {2})};

  const ShiftTable table = make_shift_table(gears, 1.0);

  ASSERT_EQ(table.equal_ratios.size(), 1U);
  EXPECT_EQ(table.equal_ratios.front(), (std::vector<int>{1, 2}));
}

TEST(ShiftTable, ListsChangesOfOneElement) {
  const std::vector<TableGear> gears = {
      gear(0, 3.0, {0, 1}), gear(1, 2.0, {0, 2}), gear(2, 1.0, {2, 3}), gear(3, -1.0, {0, 1, 2})};

  const ShiftTable table = make_shift_table(gears, 1.0);

  ASSERT_EQ(table.changes.size(), 4U);
  EXPECT_EQ(table.changes[0].opens, std::vector{1});  // 0 to 1
  EXPECT_EQ(table.changes[0].engages, std::vector{2});
  EXPECT_EQ(table.changes[0].step, 1.5);
  EXPECT_EQ(table.changes[1].to, 3);  // 0 to 3 engages 2 alone
  EXPECT_TRUE(table.changes[1].opens.empty());
  EXPECT_EQ(table.changes[1].engages, std::vector{2});
  EXPECT_FALSE(table.changes[1].step.has_value());  // from forward to reverse
}

TEST(ShiftTable, ListsTheNextGearHoweverManyElementsChange) {
  const std::vector<TableGear> gears = {gear(0, 4.0, {0, 1}),
                                        gear(1, 2.0, {2, 3}),
                                        gear(2, 2.0, {4, 5}),
                                        gear(3, 1.0, {6, 7}),
                                        gear(4, -3.0, {8, 9})};

  const ShiftTable table = make_shift_table(gears, 1.0);

  std::vector<std::vector<int>> pairs;
  for (const GearChange& change : table.changes) {
    pairs.push_back({change.from, change.to, change.elements()});
  }
  // Both gears of one ratio follow the first and come before the last; no reverse gear follows.
  EXPECT_EQ(pairs, (std::vector<std::vector<int>>{{0, 1, 4}, {0, 2, 4}, {1, 3, 4}, {2, 3, 4}}));
}

TEST(ShiftTable, SumsTheSlipsThatAreTakenUp) {
  TableGear low = gear(0, 3.0, {0, 1});
  low.slips = {0.0, 0.0, -2.0, 5.0};
  TableGear high = gear(1, 1.0, {2, 3});
  high.slips = {1.5, -0.25, 0.0, 0.0};

  const std::vector<TableGear> gears = {low, high};
  const ShiftTable table = make_shift_table(gears, 1.0);

  ASSERT_EQ(table.changes.size(), 1U);
  EXPECT_EQ(table.changes[0].slip, 7.0);        // 2 and 3 engage
  EXPECT_EQ(table.changes[0].slip_back, 1.75);  // 0 and 1
}

TEST(ShiftTable, HasNoSumOfSlipsWhereOneIsOpen) {
  TableGear low = gear(0, 3.0, {0});
  low.slips = {0.0, std::nullopt};
  TableGear high = gear(1, 1.0, {1});
  high.slips = {1.0, 0.0};

  const std::vector<TableGear> gears = {low, high};
  const ShiftTable table = make_shift_table(gears, 1.0);

  ASSERT_EQ(table.changes.size(), 1U);
  EXPECT_FALSE(table.changes[0].slip.has_value());
  EXPECT_EQ(table.changes[0].slip_back, 1.0);
}

TEST(ShiftTable, HasNoSpanWithASingleForwardGear) {
  const std::vector<TableGear> gears = {gear(0, 3.0, {0}), gear(1, -1.0, {1})};

  EXPECT_FALSE(make_shift_table(gears, 1.0).span.has_value());
}

TEST(ShiftTable, IsEmptyWithoutGears) {
  const ShiftTable table = make_shift_table({}, 1.0);

  EXPECT_TRUE(table.steps.empty());
  EXPECT_TRUE(table.changes.empty());
}

}  // namespace
}  // namespace kinestat
