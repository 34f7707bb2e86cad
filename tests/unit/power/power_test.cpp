#include <gtest/gtest.h>

#include "power/power_flow.hpp"
#include "power/ratio.hpp"

namespace kinestat {
namespace {

// Two shafts on one housing with a gear of ratio 2 between them, as solved by hand: the first turns
// at 1 rad/s under 100 N·m, the second at -0.5 rad/s against 200 N·m, radii 1 m and 2 m.
struct TwoShafts {
  Mechanism mechanism;
  Case which{.label = "drive",
             .motions = {},
             .actions = {},
             .loads = {},
             .inputs = {0},
             .outputs = {1},
             .where = {}};
  KinematicSolution motion;
  StaticSolution action;

  TwoShafts() {
    Topology& topology = mechanism.topology;
    topology.bodies = {{.name = "housing", .where = {}},
                       {.name = "in", .where = {}},
                       {.name = "out", .where = {}}};
    for (const int head : {1, 2}) {
      topology.couplings.push_back({.name = head == 1 ? "a" : "b",
                                    .type = CouplingType::revolute,
                                    .tail = BodyId{0},
                                    .head = BodyId{head},
                                    .first_freedom = head - 1,
                                    .freedom_count = 1,
                                    .first_action = head - 1,
                                    .action_count = 1,
                                    .where = {}});
      topology.freedoms.push_back(
          {.coupling = CouplingId{head - 1}, .name = "wz", .is_rotation = true});
      topology.actions.push_back({.coupling = CouplingId{head - 1},
                                  .name = head == 1 ? "T_in" : "T_out",
                                  .is_couple = true,
                                  .actuator = head - 1});
      topology.actuators.push_back({.name = head == 1 ? "T_in" : "T_out",
                                    .freedom = head - 1,
                                    .action = head - 1,
                                    .where = {}});
    }
    topology.couplings.push_back({.name = "g",
                                  .type = CouplingType::gear,
                                  .tail = BodyId{1},
                                  .head = BodyId{2},
                                  .first_freedom = 2,
                                  .freedom_count = 1,
                                  .first_action = 2,
                                  .action_count = 0,
                                  .where = {}});
    topology.freedoms.push_back({.coupling = CouplingId{2}, .name = "roll", .is_rotation = true});
    const Twist in = unit_rotation(Vec3::UnitZ(), Vec3::Zero());
    const Twist turn_of_out = unit_rotation(Vec3::UnitZ(), Vec3(0.0, 3.0, 0.0));
    const Twist out = -0.5 * turn_of_out;
    mechanism.geometry.points = {Vec3::Zero(), Vec3(0.0, 3.0, 0.0), Vec3(0.0, 1.0, 0.0)};
    mechanism.geometry.motions = {in, turn_of_out, out - in};
    motion.rates = {1.0, -0.5, 1.0};
    motion.bodies = {{}, in, out};
    motion.couplings = {in, out, out - in};
    action.magnitudes = {100.0, 200.0};
    const Wrench tooth = -100.0 * unit_force(Vec3::UnitX(), Vec3(0.0, 1.0, 0.0));
    action.wrenches = {
        100.0 * unit_couple(Vec3::UnitZ()), 200.0 * unit_couple(Vec3::UnitZ()), tooth};
  }
};

TEST(PowerFlow, IntoTheHeadIsTheWrenchOnItsMotion) {
  const TwoShafts shafts;

  const PowerFlow flow = find_power(shafts.mechanism, shafts.which, shafts.motion, shafts.action);

  EXPECT_EQ(flow.into_head[0], 100.0);
  EXPECT_EQ(flow.into_head[1], -100.0);
}

TEST(PowerFlow, OfTheTeethGoesThroughWithoutLoss) {
  const TwoShafts shafts;

  const PowerFlow flow = find_power(shafts.mechanism, shafts.which, shafts.motion, shafts.action);

  // -100 N along x on a point that moves with ω x r = -1 m/s along x.
  EXPECT_DOUBLE_EQ(flow.into_head[2].value(), 100.0);
  EXPECT_NEAR(flow.supplied[2], 0.0, 1e-13);
}

TEST(PowerFlow, InputIsThatOfTheNamedActuatorsOrOfAllThatDrive) {
  TwoShafts shafts;
  EXPECT_EQ(find_power(shafts.mechanism, shafts.which, shafts.motion, shafts.action).input, 100.0);

  shafts.which.inputs = {1};
  EXPECT_EQ(find_power(shafts.mechanism, shafts.which, shafts.motion, shafts.action).input, -100.0);

  shafts.which.inputs.clear();
  EXPECT_EQ(find_power(shafts.mechanism, shafts.which, shafts.motion, shafts.action).input, 100.0);
}

// The second shaft without its actuator, and 200 N·m on it from outside.
TwoShafts loaded_shafts() {
  TwoShafts shafts;
  shafts.mechanism.topology.actuators.pop_back();
  shafts.action.wrenches[1] = Wrench{};
  shafts.which.loads = {{.name = "brake",
                         .acts = {.body = BodyId{2}, .wrench = 200.0 * unit_couple(Vec3::UnitZ())},
                         .point = std::nullopt,
                         .where = {}}};
  return shafts;
}

TEST(PowerFlow, OfALoadIsItsWrenchOnTheMotionOfItsBody) {
  const TwoShafts shafts = loaded_shafts();

  const PowerFlow flow = find_power(shafts.mechanism, shafts.which, shafts.motion, shafts.action);

  EXPECT_EQ(flow.loads, std::vector<double>{-100.0});
  EXPECT_EQ(flow.input, 100.0);
  EXPECT_TRUE(flow.is_balanced);
}

TEST(PowerFlow, OfALoadThatDrivesIsInputUnlessTheCaseNamesOne) {
  TwoShafts shafts = loaded_shafts();
  shafts.which.loads[0].acts.wrench = -1.0 * shafts.which.loads[0].acts.wrench;
  shafts.which.inputs.clear();
  EXPECT_EQ(find_power(shafts.mechanism, shafts.which, shafts.motion, shafts.action).input, 200.0);

  shafts.which.inputs = {0};
  EXPECT_EQ(find_power(shafts.mechanism, shafts.which, shafts.motion, shafts.action).input, 100.0);
}

TEST(PowerFlow, OfALoadThatIsMissingBreaksTheBalance) {
  TwoShafts shafts = loaded_shafts();
  shafts.which.loads.clear();

  EXPECT_FALSE(
      find_power(shafts.mechanism, shafts.which, shafts.motion, shafts.action).is_balanced);
}

TEST(PowerFlow, OfABrokenBalanceSaysSo) {
  TwoShafts shafts;
  EXPECT_TRUE(find_power(shafts.mechanism, shafts.which, shafts.motion, shafts.action).is_balanced);

  shafts.action.wrenches[1] = 200.001 * unit_couple(Vec3::UnitZ());
  const PowerFlow flow = find_power(shafts.mechanism, shafts.which, shafts.motion, shafts.action);

  EXPECT_FALSE(flow.is_balanced);
  EXPECT_NEAR(flow.balance_residual, 5e-6, 1e-8);
}

// About a point 1e9 m off the couple of the tooth is 1e11 N·m, of which 1.5e-5 is the last digit.
TEST(PowerFlow, FarFromTheOriginMayRoundBeyondTheBalance) {
  TwoShafts shafts;
  const Vec3 far(0.0, 1e9, 0.0);
  for (auto* twists :
       {&shafts.motion.bodies, &shafts.motion.couplings, &shafts.mechanism.geometry.motions}) {
    for (Twist& twist : *twists) {
      twist.linear += far.cross(twist.angular);
    }
  }
  Wrench& tooth = *shafts.action.wrenches[2];
  tooth.moment += far.cross(tooth.force);
  const auto is_balanced_with = [&](double couple) {
    TwoShafts off = shafts;
    off.action.wrenches[2]->moment.z() += couple;
    return find_power(off.mechanism, off.which, off.motion, off.action).is_balanced;
  };

  EXPECT_TRUE(is_balanced_with(1.5e-5));
  EXPECT_FALSE(is_balanced_with(1e-2));
}

TEST(PowerFlow, HasABoundWhereRatesAndActionsHave) {
  TwoShafts shafts;
  const auto bound = [&] {
    return find_power(shafts.mechanism, shafts.which, shafts.motion, shafts.action).error_bound;
  };
  EXPECT_FALSE(bound());

  shafts.motion.answer.bounds = {0.0, 1e-6, 0.0};
  EXPECT_FALSE(bound());

  shafts.action.answer.bounds = {1e-4, 2e-4};
  // 1e-4·1 of the input, 200·1e-6 + 0.5·2e-4 of the output, of 100 W.
  EXPECT_NEAR(*bound(), 4e-6, 1e-11);
}

TEST(Ratios, HaveBoundsWhereRatesAndActionsHave) {
  TwoShafts shafts;
  shafts.motion.answer.bounds = {0.0, 1e-6, 0.0};
  shafts.action.answer.bounds = {1e-4, 2e-4};

  const Ratios ratios = find_ratios(shafts.mechanism, shafts.which, shafts.motion, &shafts.action);

  EXPECT_NEAR(*ratios.ratio_bound, 2e-6, 1e-11);         // 1e-6 of 0.5
  EXPECT_NEAR(*ratios.torque_ratio_bound, 2e-6, 1e-11);  // 1e-6 of each
}

TEST(Ratios, AreInputOverOutput) {
  const TwoShafts shafts;

  const Ratios ratios = find_ratios(shafts.mechanism, shafts.which, shafts.motion, &shafts.action);

  EXPECT_EQ(ratios.ratio, -2.0);
  EXPECT_EQ(ratios.torque_ratio, 0.5);
  EXPECT_EQ(ratios.reason, "");
  EXPECT_FALSE(ratios.ratio_bound);
  EXPECT_FALSE(ratios.torque_ratio_bound);
}

TEST(Ratios, OfAnOutputAtRestHaveAReasonInstead) {
  TwoShafts shafts;
  shafts.motion.rates[1] = 0.0;

  const Ratios ratios = find_ratios(shafts.mechanism, shafts.which, shafts.motion, nullptr);

  EXPECT_FALSE(ratios.ratio);
  EXPECT_EQ(ratios.reason, "output 'T_out' is at rest");
}

TEST(Ratios, OfSeveralInputsNeedOneRate) {
  TwoShafts shafts;
  shafts.which.inputs = {0, 1};

  const Ratios ratios = find_ratios(shafts.mechanism, shafts.which, shafts.motion, &shafts.action);

  EXPECT_FALSE(ratios.ratio);
  EXPECT_FALSE(ratios.torque_ratio);
  EXPECT_EQ(ratios.reason, "the inputs have different rates");
}

TEST(Ratios, OfInputsThatTurnTogetherAddTheirActions) {
  TwoShafts shafts;
  shafts.motion.rates = {1.0, 1.0};
  shafts.which.inputs = {0, 1};

  const Ratios ratios = find_ratios(shafts.mechanism, shafts.which, shafts.motion, &shafts.action);

  EXPECT_EQ(ratios.ratio, 1.0);
  EXPECT_EQ(ratios.torque_ratio, 1.5);
}

// A third shaft beside the two of the gear; together the inputs bear nothing.
struct ThreeInputs : TwoShafts {
  ThreeInputs() {
    for (const double couple : {-0.1, -0.2}) {
      const int index = static_cast<int>(action_count());
      mechanism.topology.actuators.push_back(
          {.name = "T", .freedom = 0, .action = index, .where = {}});
      which.inputs.push_back(index);
      action.magnitudes.emplace_back(couple);
    }
    action.magnitudes[0] = 0.3;
  }

  std::size_t action_count() const { return action.magnitudes.size(); }
};

// 0.3 - 0.1 - 0.2 is -2.8e-17 of numbers as they are rounded, 0.1 + 0.2 - 0.3 is 5.6e-17.
TEST(Ratios, OfInputsThatCancelAreZero) {
  for (const std::vector<int>& order : {std::vector{0, 2, 3}, std::vector{2, 3, 0}}) {
    ThreeInputs shafts;
    shafts.which.inputs = order;
    for (const std::vector<double>& bounds : {std::vector<double>{}, std::vector<double>(4)}) {
      shafts.action.answer.bounds = bounds;

      const Ratios ratios =
          find_ratios(shafts.mechanism, shafts.which, shafts.motion, &shafts.action);

      EXPECT_EQ(ratios.torque_ratio, 0.0);
      EXPECT_FALSE(ratios.advantage);
    }
  }
}

TEST(PowerFlow, OfInputsThatCancelIsNone) {
  const ThreeInputs shafts;

  EXPECT_EQ(find_power(shafts.mechanism, shafts.which, shafts.motion, shafts.action).input, 0.0);
}

// The drive gives 1.05 µW, of which the output takes 1; a weight of 1e9 N, whose body sinks at
// 1e-16 m/s or not at all, may have the rest, which is half of what its bound leaves open.
TEST(PowerFlow, MayRoundByWhatItsPartsMayBeOff) {
  TwoShafts shafts;
  shafts.motion.rates = {1e-8, -0.5e-8, 1e-8};
  for (auto* twists : {&shafts.motion.bodies, &shafts.motion.couplings}) {
    for (Twist& twist : *twists) {
      twist = 1e-8 * twist;
    }
  }
  shafts.action.magnitudes[0] = 105.0;
  shafts.action.wrenches[0] = 105.0 * unit_couple(Vec3::UnitZ());
  shafts.motion.bodies[1].linear.y() = -1e-16;
  shafts.motion.body_bounds = std::vector<Twist>(3);
  shafts.which.loads.push_back(
      {.name = "weight",
       .acts = {.body = BodyId{1}, .wrench = 1e9 * unit_force(Vec3::UnitY(), Vec3::Zero())},
       .point = {},
       .where = {}});
  const auto flow = [&] {
    return find_power(shafts.mechanism, shafts.which, shafts.motion, shafts.action);
  };
  EXPECT_FALSE(flow().is_balanced);

  shafts.motion.body_bounds[1].linear.y() = 1.1e-16;
  EXPECT_TRUE(flow().is_balanced);
  EXPECT_EQ(flow().loads[0], 0.0);
}

}  // namespace
}  // namespace kinestat
