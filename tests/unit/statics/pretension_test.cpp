#include "statics/pretension.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "network/bases.hpp"
#include "statics/action.hpp"
#include "statics/one_sided_action.hpp"
#include "support/mechanism_text.hpp"

namespace kinestat {
namespace {

struct Pretensioned {
  Mechanism mechanism;
  CoordinateBasis basis;
  StaticSolution solution;

  explicit Pretensioned(const std::string& text)
      : mechanism(mechanism_of(text)),
        basis(action_basis(mechanism.geometry, OrderChoice::minimal, {})) {
    const Case& which = mechanism.cases.front();
    const std::vector<BodyWrench> loads = wrenches_of(which.loads);
    solution = solve_action(mechanism,
                            action_basis(mechanism.geometry, OrderChoice::minimal, loads),
                            which.actions,
                            loads);
    EXPECT_EQ(solution.status, SolveStatus::solved);
  }

  std::vector<std::string> pushed() const {
    std::vector<std::string> names;
    for (const CouplingId id : find_pushed_segments(mechanism, solution)) {
      names.push_back(mechanism.topology.coupling(id).name);
    }
    return names;
  }

  double pretension(const std::string& action) const {
    const std::optional<VecX> found = find_pretension(mechanism, basis, solution);
    return found ? (*found)[action_index(mechanism, action)] : std::nan("");
  }
};

using Names = std::vector<std::string>;

// Two pulleys of radius 1; the torque 60 makes the tensions differ by 60.
std::string belts(const std::string& case_text) {
  return "space: planar\n"
         "ground: frame\n"
         "bodies: [driver, driven, third]\n"
         "couplings:\n"
         "  A: {type: revolute, bodies: [frame, driver], at: [0, 0]}\n"
         "  B: {type: revolute, bodies: [frame, driven], at: [5, 0]}\n"
         "  C: {type: revolute, bodies: [frame, third], at: [5, 7]}\n"
         "cables:\n"
         "  belt:\n"
         "    closed: true\n"
         "    over: [{pulley: driver, radius: 1, wrap: clockwise},\n"
         "           {pulley: driven, radius: 1, wrap: clockwise}]\n"
         "  chain:\n"
         "    closed: true\n"
         "    over: [{pulley: driven, radius: 2, wrap: clockwise},\n"
         "           {pulley: third, radius: 2, wrap: clockwise}]\n"
         "actuators: {in: {coupling: A}, out: {coupling: C}}\n"
         "cases: {one: {" +
         case_text + "}}\n";
}

TEST(Pretension, IsNoneWhereAllSegmentsPull) {
  const Pretensioned belt(belts("action: {in: -60, belt_1.F: 5, chain_1.F: 5}"));

  EXPECT_EQ(belt.pushed(), Names{});
}

TEST(Pretension, LiftsTheSlackSegmentOfEachBeltToZero) {
  // Tight 10 and 5, slack 10 - 60 and 5 - 60/2: a pretension of 50 and of 25.
  const Pretensioned belt(belts("action: {in: -60, belt_2.F: 10, chain_2.F: 5}"));

  EXPECT_EQ(belt.pushed(), (Names{"belt_1", "chain_1"}));
  EXPECT_NEAR(belt.pretension("belt_1.F"), 50.0, 1e-10);
  EXPECT_NEAR(belt.pretension("belt_2.F"), 50.0, 1e-10);
  EXPECT_NEAR(belt.pretension("chain_1.F"), 25.0, 1e-10);
  EXPECT_NEAR(belt.pretension("chain_2.F"), 25.0, 1e-10);
  EXPECT_NEAR(belt.pretension("in"), 0.0, 1e-10);
}

TEST(Pretension, CombinesSelfStressesSoThatTheSumOfTensionsIsLeast) {
  // A slide between cables in one line, two to the left and one to the right: T1 + T2 = T3.
  const Pretensioned cables(
      "space: planar\n"
      "ground: frame\n"
      "bodies: [slide]\n"
      "couplings:\n"
      "  a: {type: prismatic, bodies: [frame, slide], at: [0, 0], axis: x}\n"
      "  r1: {type: cable, bodies: [frame, slide], from: [-5, 0], to: [0, 0]}\n"
      "  r2: {type: cable, bodies: [frame, slide], from: [-5, 0], to: [0, 0]}\n"
      "  r3: {type: cable, bodies: [frame, slide], from: [5, 0], to: [0, 0]}\n"
      "cases: {one: {action: {r1.F: -8, r2.F: 3}}}\n");

  // r3 is -8 + 3 = -5: r1 needs 8, which r3 bears too; r2 stays as it is.
  EXPECT_EQ(cables.pushed(), (Names{"r1", "r3"}));
  EXPECT_NEAR(cables.pretension("r1.F"), 8.0, 1e-10);
  EXPECT_NEAR(cables.pretension("r2.F"), 0.0, 1e-10);
  EXPECT_NEAR(cables.pretension("r3.F"), 8.0, 1e-10);
}

TEST(Pretension, DoesNotExistForARopeThatNothingStretches) {
  const Pretensioned cable(
      "space: planar\n"
      "ground: frame\n"
      "bodies: [load]\n"
      "couplings: {a: {type: prismatic, bodies: [frame, load], axis: y}}\n"
      "cables: {rope: {over: [{body: frame, at: [0, 1]}, {body: load, at: [0, 0]}]}}\n"
      "loads: {lift: {body: load, at: [0, 0], force: [0, 12]}}\n"
      "cases: {one: {action: {}}}\n");

  EXPECT_EQ(cable.pushed(), Names{"rope_1"});
  EXPECT_FALSE(find_pretension(cable.mechanism, cable.basis, cable.solution));
}

}  // namespace
}  // namespace kinestat
