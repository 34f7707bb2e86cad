#include "studies/shift/shift_solution.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "unit/shift/two_speed_train.hpp"

namespace kinestat {
namespace {

// C(4, 2), C(5, 3), C(20, 10), and beyond numbers.
TEST(Combinations, AreCounted) {
  EXPECT_EQ(combination_count(4, 2), 6.0);
  EXPECT_EQ(combination_count(5, 3), 10.0);
  EXPECT_EQ(combination_count(20, 10), 184756.0);
  EXPECT_EQ(combination_count(3, 0), 1.0);
  EXPECT_EQ(combination_count(3, 4), 0.0);
  EXPECT_TRUE(std::isinf(combination_count(4000, 2000)));
}

ShiftSolution solve(const Mechanism& mechanism, const ShiftPlan& plan, const ShiftOptions& more) {
  return find_shift_solution(
      mechanism, motion_basis(mechanism.geometry, mechanism.kinematic_order), plan, more);
}

std::vector<std::string> names_of(const ShiftSolution& solution) {
  std::vector<std::string> names;
  for (const NamedShiftState& one : solution.states) {
    names.push_back(one.name);
  }
  return names;
}

TEST(ShiftSolution, NamesStatesByLabelOrElements) {
  const Mechanism mechanism = mechanism_of(two_speed_text());
  ShiftPlan plan = plan_of(mechanism, {"C", "B"});
  plan.labels = {{.text = "low", .engaged = {1}, .where = {}}};

  const ShiftSolution all = solve(mechanism, plan, {.one_more = true, .one_fewer = true});

  EXPECT_EQ(names_of(all), (std::vector<std::string>{"low", "C", "none", "C+B"}));
  EXPECT_EQ(all.possibilities, 2.0);
}

// Fault 80: a class in the table with its reason.
TEST(ShiftSolution, ClassesALabelOfTheWrongSize) {
  const Mechanism mechanism = mechanism_of(two_speed_text());
  ShiftPlan plan = plan_of(mechanism, {"C", "B"});
  plan.labels = {{.text = "both", .engaged = {0, 1}, .where = {}}};

  const ShiftSolution all = solve(mechanism, plan, {});

  EXPECT_EQ(names_of(all), (std::vector<std::string>{"B", "C", "both"}));
  EXPECT_EQ(all.states[2].state.kind, ShiftClass::locked_by_elements);
  EXPECT_EQ(all.states[2].reason,
            "engages 2 elements where a gear needs 1: input 'in' is locked; locked bodies: sun, "
            "ring, carrier, planet; no freedom remains");
}

TEST(ShiftSolution, CountsButDoesNotSolveTooManyCombinations) {
  const Mechanism mechanism = mechanism_of(two_speed_text());
  ShiftPlan plan = plan_of(mechanism, {});
  plan.elements.assign(6000, {.actuator = actuator_index(mechanism, "B"), .one_way = 0});

  const ShiftSolution all = solve(mechanism, plan, {});

  EXPECT_TRUE(all.is_too_long);
  EXPECT_EQ(all.asked, 6000.0);
  EXPECT_TRUE(all.states.empty());
}

}  // namespace
}  // namespace kinestat
