#include "studies/shift/shift_state.hpp"

#include <gtest/gtest.h>

#include "studies/shift/solved_gear.hpp"
#include "unit/shift/two_speed_train.hpp"

namespace kinestat {
namespace {

// Exact to a few roundings.
constexpr double kRounding = 1e-13;

class TwoSpeedTrain : public ::testing::Test {
 protected:
  ShiftState state(const std::vector<int>& engaged) const {
    return solve_shift_state(network_of(mechanism_, plan_), plan_, engaged);
  }

  Mechanism mechanism_ =
      mechanism_of(two_speed_text("  D: {type: brake, bodies: [housing, ring], at: [0, 0]}\n"
                                  "  E: {type: brake, bodies: [housing, carrier], at: [0, 0]}\n"
                                  "  S: {type: brake, bodies: [housing, sun], at: [0, 0]}\n"));
  ShiftPlan plan_ = plan_of(mechanism_, {"C", "B", "D", "E", "S"});
};

TEST_F(TwoSpeedTrain, NeedsOneElementForAGear) {
  EXPECT_EQ(network_of(mechanism_, plan_).net_freedom(), 2);
  EXPECT_EQ(network_of(mechanism_, plan_).needed(), 1);
}

// Willis with the ring at rest: ω_s/ω_c = 1 + Nr/Ns = 10/3.
TEST_F(TwoSpeedTrain, HasTheRatioOfWillisWithTheRingHeld) {
  const ShiftState one = state({1});

  EXPECT_EQ(one.kind, ShiftClass::gear);
  EXPECT_EQ(one.idle, 0);
  EXPECT_NEAR(one.outputs.front().value(), 3.0, kRounding);
  EXPECT_NEAR(one.slips[0].value(), -10.0, kRounding);  // the ring rests, the sun turns at 10
  EXPECT_EQ(one.slips[1].value(), 0.0);
}

// T_out = -i T_in, and the brake bears what is left: T_in + T_out + T_B = 0 on the whole train.
TEST_F(TwoSpeedTrain, HasTheTorquesOfVirtualPower) {
  const ShiftState one = state({1});

  EXPECT_NEAR(one.output_torques.front(), -10.0, kRounding);
  EXPECT_NEAR(one.torques[1], 7.0, kRounding);
  EXPECT_EQ(one.torques[0], 0.0);
}

TEST_F(TwoSpeedTrain, TurnsAsABlockWithTheClutch) {
  const ShiftState one = state({0});

  EXPECT_EQ(one.kind, ShiftClass::gear);
  EXPECT_NEAR(one.outputs.front().value(), 10.0, kRounding);
  EXPECT_NEAR(one.torques[0], 3.0 * 0.7, kRounding);  // the ring's share: Nr/(Ns + Nr)
}

// A gear that leaves freedoms beside it has a case without velocities, or none at all.
TEST_F(TwoSpeedTrain, KnowsSlipsThatItsCaseDoesNot) {
  const ShiftState one = state({1});
  const Case which;
  SolvedGear gear{.mechanism = mechanism_, .plan = plan_, .state = one, .which = which};
  EXPECT_NEAR(slip_of(gear, 0).value(), -10.0, kRounding);

  KinematicSolution open;
  open.status = SolveStatus::underdetermined;
  gear.motion = &open;
  EXPECT_NEAR(slip_of(gear, 0).value(), -10.0, kRounding);
}

// A second machine on the ring, and one between carrier and planets, which reacts: by Willis the
// planets turn beside the carrier by -3/2 (w_s - w_c), where w_c = 0.3 w_s + 0.7 w_r.
TEST(ShiftState, SharesTheSpeedOfWhatReactsAmongTheInputs) {
  std::string text = two_speed_text();
  text.replace(text.find("out: {"), 0, "ring: {coupling: r}, rolls: {coupling: p}, ");
  const Mechanism mechanism = mechanism_of(text);
  ShiftPlan plan = plan_of(mechanism, {});
  plan.inputs.push_back(shift_input(mechanism, "ring", 4.0, std::nullopt));
  plan.others = {actuator_index(mechanism, "rolls")};
  plan.reacting = {0};

  const ShiftState one = solve_shift_state(network_of(mechanism, plan), plan, {});

  ASSERT_EQ(one.reactions.size(), 1U);
  EXPECT_NEAR(one.reactions.front().rate.value(), -1.05 * (10.0 - 4.0), kRounding);
  ASSERT_EQ(one.reactions.front().speed_shares.size(), 2U);
  EXPECT_NEAR(one.reactions.front().speed_shares[0], -1.05, kRounding);
  EXPECT_NEAR(one.reactions.front().speed_shares[1], 1.05, kRounding);
}

TEST_F(TwoSpeedTrain, IdlesWithoutAnElement) {
  const ShiftState none = state({});

  EXPECT_EQ(none.kind, ShiftClass::neutral);
  EXPECT_EQ(none.cause, ShiftCause::output_free);
  EXPECT_EQ(none.freedom, 2);
  EXPECT_EQ(none.idle, 1);
}

TEST_F(TwoSpeedTrain, IsLockedWithTheInputHeld) {
  EXPECT_EQ(state({4}).cause, ShiftCause::input_held);
  EXPECT_EQ(state({0, 1}).cause, ShiftCause::input_held);
}

TEST_F(TwoSpeedTrain, IsLockedWithTheOutputHeld) {
  const ShiftState held = state({3});

  EXPECT_EQ(held.kind, ShiftClass::locked_by_elements);
  EXPECT_EQ(held.cause, ShiftCause::outputs_held);
}

TEST_F(TwoSpeedTrain, TiesUpWithTwoBrakesOnOneBody) {
  const ShiftState tied = state({1, 2});

  EXPECT_EQ(tied.kind, ShiftClass::tie_up);
  EXPECT_EQ(tied.surplus, std::vector<int>{2});
}

// Input held comes before output held, neutral and tie-up.
TEST_F(TwoSpeedTrain, DecidesInTheOrderOfTheClasses) {
  EXPECT_EQ(state({1, 2, 4}).cause, ShiftCause::input_held);
  EXPECT_EQ(state({1, 2, 3}).cause, ShiftCause::input_held);
}

// The torque of B is +7: housing on ring.
TEST_F(TwoSpeedTrain, HoldsWithAFreewheelOfTheRightSign) {
  plan_.elements[1].one_way = 1;

  EXPECT_EQ(state({1}).kind, ShiftClass::gear);
}

TEST_F(TwoSpeedTrain, IdlesWithAFreewheelOfTheOtherSign) {
  plan_.elements[1].one_way = -1;

  EXPECT_EQ(state({1}).kind, ShiftClass::neutral);
  EXPECT_EQ(state({1}).cause, ShiftCause::freewheel_overruns);
  EXPECT_EQ(state({1}).which, 1);
}

TEST_F(TwoSpeedTrain, TakesAnInputWithoutActionToDrive) {
  plan_.asks_actions = false;
  plan_.inputs.front().action.reset();
  plan_.elements[1].one_way = 1;
  EXPECT_EQ(state({1}).kind, ShiftClass::gear);
  EXPECT_TRUE(state({1}).torques.empty());

  plan_.elements[1].one_way = -1;
  EXPECT_EQ(state({1}).cause, ShiftCause::freewheel_overruns);
}

// With the clutch engaged the ring turns forwards: a freewheel that holds it in that sense ties up.
TEST_F(TwoSpeedTrain, TiesUpWhereAnOpenFreewheelWouldHold) {
  plan_.elements[1].one_way = -1;
  EXPECT_EQ(state({0}).kind, ShiftClass::tie_up);
  EXPECT_EQ(state({0}).cause, ShiftCause::freewheel_locks);

  plan_.elements[1].one_way = 1;
  EXPECT_EQ(state({0}).kind, ShiftClass::gear);
}

// Clutch and freewheel engaged: the ring turns with the sun, out of the freewheel's hold or into
// it.
TEST_F(TwoSpeedTrain, IsTheGearOfTheClutchWhileAnEngagedFreewheelOverruns) {
  plan_.elements[1].one_way = 1;
  const ShiftState direct = state({0, 1});

  EXPECT_EQ(direct.kind, ShiftClass::gear);
  EXPECT_EQ(direct.overrunning, std::vector<int>{1});
  EXPECT_NEAR(direct.outputs.front().value(), 10.0, kRounding);
  EXPECT_NEAR(direct.slips[1].value(), 10.0, kRounding);
  EXPECT_EQ(direct.torques[1], 0.0);

  plan_.elements[1].one_way = -1;
  EXPECT_EQ(state({0, 1}).cause, ShiftCause::input_held);
}

// Two freewheels in parallel: where one is engaged the other has no slip, and may be open.
TEST_F(TwoSpeedTrain, LetsAFreewheelWithoutSlipBeOpen) {
  plan_.elements[2].one_way = -1;

  EXPECT_EQ(state({1}).kind, ShiftClass::gear);
}

// Sun and ring driven: carrier by Willis (30·10 + 70·4)/100, torques as 30 : 70 : -100.
TEST_F(TwoSpeedTrain, AddsTheSpeedsOfTwoInputs) {
  Mechanism mechanism = mechanism_of(two_speed_text().replace(
      two_speed_text().find("out: {coupling: c}"), 18, "out: {coupling: c}, in2: {coupling: r}"));
  ShiftPlan plan = plan_of(mechanism, {});
  plan.inputs.push_back(shift_input(mechanism, "in2", 4.0, std::nullopt));

  const ShiftState both = solve_shift_state(network_of(mechanism, plan), plan, {});

  EXPECT_EQ(both.kind, ShiftClass::gear);
  EXPECT_NEAR(both.outputs.front().value(), 5.8, kRounding);
  EXPECT_NEAR(both.input_torques[1], 7.0, kRounding);
  EXPECT_NEAR(both.output_torques[0], -10.0, kRounding);
}

// A motor at rest is an input all the same: the carrier then turns at 30/100 of the other.
TEST_F(TwoSpeedTrain, LetsOneOfTwoInputsRest) {
  Mechanism mechanism = mechanism_of(two_speed_text().replace(
      two_speed_text().find("out: {coupling: c}"), 18, "out: {coupling: c}, in2: {coupling: r}"));
  ShiftPlan plan = plan_of(mechanism, {"B"});
  plan.inputs.insert(plan.inputs.begin(), shift_input(mechanism, "in2", 0.0, std::nullopt));
  plan.asks_actions = false;
  plan.inputs[1].action.reset();

  const std::vector<int> none;
  const ShiftState free = solve_shift_state(network_of(mechanism, plan), plan, none);
  EXPECT_EQ(free.kind, ShiftClass::gear);
  EXPECT_NEAR(free.outputs.front().value(), 3.0, kRounding);
  EXPECT_EQ(free.moving, (std::vector<int>{0, 1}));

  // The brake holds what rests anyway.
  const std::vector<int> brake = {0};
  const ShiftState held = solve_shift_state(network_of(mechanism, plan), plan, brake);
  EXPECT_EQ(held.kind, ShiftClass::gear);
  EXPECT_NEAR(held.outputs.front().value(), 3.0, kRounding);
  EXPECT_EQ(held.moving, std::vector<int>{1});
}

// Two brakes on one body share its torque as they like.
TEST_F(TwoSpeedTrain, TellsThatTheSignOfAFreewheelIsOpen) {
  plan_.outputs.push_back(actuator_index(mechanism_, "B"));
  plan_.elements = {plan_.elements[2]};
  plan_.elements[0].one_way = 1;

  const ShiftState shared = state({0});

  EXPECT_EQ(shared.kind, ShiftClass::gear);
  EXPECT_EQ(shared.open_freewheels, std::vector<int>{0});
}

TEST_F(TwoSpeedTrain, RefusesInputsThatTheClutchCouples) {
  Mechanism mechanism = mechanism_of(two_speed_text().replace(
      two_speed_text().find("out: {coupling: c}"), 18, "out: {coupling: c}, in2: {coupling: r}"));
  ShiftPlan plan = plan_of(mechanism, {"C"});
  plan.inputs.push_back(shift_input(mechanism, "in2", 4.0, std::nullopt));
  const std::vector<int> clutch = {0};

  const ShiftState coupled = solve_shift_state(network_of(mechanism, plan), plan, clutch);
  EXPECT_EQ(coupled.cause, ShiftCause::inputs_coupled);

  plan.inputs[1].speed = 10.0;
  const ShiftState agreed = solve_shift_state(network_of(mechanism, plan), plan, clutch);
  EXPECT_EQ(agreed.kind, ShiftClass::gear);
  EXPECT_EQ(agreed.moving, std::vector<int>{0});
}

}  // namespace
}  // namespace kinestat
