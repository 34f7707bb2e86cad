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
  EXPECT_EQ(table.changes[0].opens, 1);  // 0 to 1
  EXPECT_EQ(table.changes[0].engages, 2);
  EXPECT_EQ(table.changes[1].to, 3);  // 0 to 3 engages 2 alone
  EXPECT_EQ(table.changes[1].opens, -1);
  EXPECT_EQ(table.changes[1].engages, 2);
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
