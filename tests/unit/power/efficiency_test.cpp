#include "power/efficiency.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

// Actuators 0 and 1 are inputs, 2 is the output, 3 neither.
Case drive() {
  Case which;
  which.inputs = {0, 1};
  which.outputs = {2};
  return which;
}

// Of four shafts, none of them a clutch.
Topology motors() {
  Topology topology;
  topology.bodies.resize(2);
  topology.couplings.resize(1);
  topology.freedoms.resize(1);
  for (const char* name : {"engine", "motor", "wheels", "fan"}) {
    topology.actuators.push_back({.name = name, .freedom = 0, .action = 0, .where = {}});
  }
  return topology;
}

Efficiency efficiency_of(const Case& which,
                         const std::vector<double>& actuators,
                         const std::vector<double>& loads = {}) {
  return find_efficiency(
      motors(), which, {.actuators = actuators, .loads = loads, .largest = 100.0});
}

TEST(Efficiency, IsWhatLeavesOfAllThatEnters) {
  const Efficiency found = efficiency_of(drive(), {60.0, 40.0, -97.0, 0.0});

  EXPECT_EQ(found.value, 0.97);
  EXPECT_TRUE(found.reason.empty());
  EXPECT_FALSE(found.is_self_locking);
}

TEST(Efficiency, HasNoValueWithoutNames) {
  const Efficiency found = efficiency_of(Case{}, {100.0, 0.0, -97.0, 0.0});

  EXPECT_FALSE(found.value.has_value());
  EXPECT_TRUE(found.reason.empty());
}

TEST(Efficiency, HasNoValueWhereOthersExchangePower) {
  EXPECT_EQ(efficiency_of(drive(), {100.0, 0.0, -97.0, 1.0}).reason,
            "actuator 'fan' also supplies or absorbs power; list it under 'input' or 'output'");
  Case engine_to_motor;
  engine_to_motor.inputs = {0};
  engine_to_motor.outputs = {1};
  EXPECT_EQ(efficiency_of(engine_to_motor, {100.0, -90.0, -9.0, -1.0}).reason,
            "actuators 'wheels', 'fan' also supply or absorb power; list them under 'input' or "
            "'output'");
  Case in_wind = drive();
  in_wind.loads.push_back({.name = "wind", .acts = {}, .point = {}, .where = {}});
  EXPECT_EQ(efficiency_of(in_wind, {100.0, 0.0, -97.0, 0.0}, {-1.0}).reason,
            "load 'wind' also supplies or absorbs power; list it under 'input' or 'output'");
  EXPECT_EQ(efficiency_of(in_wind, {100.0, 0.0, -90.0, -9.0}, {-1.0}).reason,
            "actuator 'fan' and load 'wind' also supply or absorb power; list them under 'input' "
            "or 'output'");
  Case in_wind_and_rain = in_wind;
  in_wind_and_rain.loads.push_back({.name = "rain", .acts = {}, .point = {}, .where = {}});
  in_wind_and_rain.loads.push_back({.name = "snow", .acts = {}, .point = {}, .where = {}});
  EXPECT_EQ(efficiency_of(in_wind_and_rain, {100.0, 0.0, -97.0, 0.0}, {-1.0, 3.0, -2.0}).reason,
            "loads 'wind', 'rain', 'snow' also supply or absorb power; list them under 'input' or "
            "'output'");
  in_wind.loads.front().name = "inertia.rotor";  // which no case can name
  EXPECT_EQ(efficiency_of(in_wind, {100.0, 0.0, -97.0, 0.0}, {-1.0}).reason,
            "the kinetic energy of the bodies also supplies or absorbs power");
}

TEST(Efficiency, HasNoValueWhereOneInputTakesPower) {
  EXPECT_EQ(efficiency_of(drive(), {100.0, -20.0, -70.0, 0.0}).reason,
            "one of the inputs absorbs power");
}

TEST(Efficiency, HasNoValueWhereOneOutputGivesPower) {
  Case which = drive();
  which.outputs = {2, 3};

  EXPECT_EQ(efficiency_of(which, {100.0, 0.0, -110.0, 20.0}).reason,
            "one of the outputs supplies power");
}

TEST(Efficiency, HasNoValueInReverse) {
  EXPECT_EQ(efficiency_of(drive(), {-97.0, 0.0, 100.0, 0.0}).reason,
            "the inputs absorb power: the outputs drive");
}

TEST(Efficiency, IsNeverAboveOne) {
  EXPECT_EQ(efficiency_of(drive(), {100.0, 0.0, -100.00000000000001, 0.0}).value, 1.0);
  EXPECT_EQ(efficiency_of(drive(), {100.0, 0.0, -101.0, 0.0}).reason, "the powers do not balance");
}

TEST(Efficiency, HasNoValueWithoutPower) {
  EXPECT_EQ(efficiency_of(drive(), {0.0, 0.0, 0.0, 0.0}).reason, "the inputs supply no power");
}

// Two inputs whose powers cancel but for their rounding.
TEST(Efficiency, HasNoValueWhereTheInputsCancel) {
  EXPECT_EQ(efficiency_of(drive(), {3.0, -3.0000000000000004, 0.0, 0.0}).reason,
            "the inputs supply no power");
}

TEST(Efficiency, IsSelfLockingWhereTheOutputDrivesToo) {
  const Efficiency found = efficiency_of(drive(), {100.0, 0.0, 10.0, 0.0});

  EXPECT_FALSE(found.value.has_value());
  EXPECT_TRUE(found.is_self_locking);
}

TEST(Efficiency, OfZeroHasAReason) {
  const Efficiency found = efficiency_of(drive(), {100.0, 0.0, 1e-12, 0.0});

  EXPECT_EQ(found.value, 0.0);
  EXPECT_EQ(found.reason, "friction absorbs all power of the inputs");
}

}  // namespace
}  // namespace kinestat
