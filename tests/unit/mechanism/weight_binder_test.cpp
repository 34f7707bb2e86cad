#include <gtest/gtest.h>

#include "mechanism/cases/load_binder.hpp"
#include "support/mechanism_text.hpp"
#include "support/near.hpp"
#include "unit/mechanism/checked_text.hpp"

namespace kinestat {
namespace {

Mechanism arm(const std::string& body, const std::string& gravity) {
  return mechanism_of("units: {length: mm}\nground: base\nbodies: {arm: " + body +
                      "}\ncouplings: {a: {type: rigid, bodies: [base, arm], at: [0, 0, 0]}}\n" +
                      gravity + "cases: {one: {motion: {}}}\n");
}

TEST(Weight, IsMassTimesGravityAtTheCentreOfMass) {
  const Mechanism mechanism =
      arm("{mass: 3 kg, centre_of_mass: [2000, 500, 1000]}", "gravity: [1 m/s^2, 0, -10 m/s^2]\n");

  // F = 3 (1, 0, -10) = (3, 0, -30) N at p = (2, 1/2, 1) m: p x F = (-15, 63, -3/2) N·m.
  ASSERT_EQ(mechanism.cases.at(0).loads.size(), 1U);
  const Load& weight = mechanism.cases[0].loads[0];
  EXPECT_EQ(weight.name, "gravity.arm");
  EXPECT_EQ(weight.acts.body, BodyId{1});
  EXPECT_TRUE(is_near(weight.acts.wrench.force, Vec3(3.0, 0.0, -30.0), 1e-13));
  EXPECT_TRUE(is_near(weight.acts.wrench.moment, Vec3(-15.0, 63.0, -1.5), 1e-12));
  EXPECT_TRUE(is_near(weight.point.value(), Vec3(2.0, 0.5, 1.0), kTight));
}

TEST(Weight, AsksForTheActionsOfEveryCase) {
  EXPECT_TRUE(arm("{mass: 3, centre_of_mass: [0, 0, 0]}", "gravity: [0, 0, -9810]\n")
                  .cases.at(0)
                  .asks_actions);
}

TEST(Weight, IsNoneWithoutGravity) {
  const Mechanism mechanism = arm("{mass: 3}", "");

  EXPECT_TRUE(mechanism.cases.at(0).loads.empty());
  EXPECT_FALSE(mechanism.cases[0].asks_actions);
}

TEST(Weight, OfABodyWithoutMassIsNone) {
  const Mechanism mechanism = mechanism_of(
      "ground: base\nbodies: {light: , heavy: {mass: 2, centre_of_mass: [0, 0, 0]}}\n"
      "couplings:\n"
      "  a: {type: rigid, bodies: [base, light], at: [0, 0, 0]}\n"
      "  b: {type: rigid, bodies: [light, heavy], at: [0, 0, 0]}\n"
      "gravity: [0, 0, -9.81]\n"
      "cases: {one: {action: {}}}\n");

  ASSERT_EQ(mechanism.cases.at(0).loads.size(), 1U);
  EXPECT_EQ(mechanism.cases[0].loads[0].acts.body, BodyId{2});
}

// The gear set has bodies as a list, so it is written anew.
Complaints complaints_of_arm(const std::string& body, const std::string& gravity) {
  return complaints_of(
      check_of("kinestat: 1\nspace: planar\nground: base\nbodies: {arm: " + body +
               "}\ncouplings: {a: {type: revolute, bodies: [base, arm], at: [0, 0]}}\n" + gravity));
}

TEST(WeightBinder, WantsACentreForAMassOnWhichGravityActs) {
  EXPECT_EQ(complaints_of_arm("{mass: 3}", "gravity: [0, -9.81]\n"),
            Complaints{"4:22 E0303 body 'arm' has a mass, on which gravity acts, but no centre of "
                       "mass"});
}

TEST(WeightBinder, RefusesANegativeMass) {
  EXPECT_EQ(complaints_of_arm("{mass: -3}", ""),
            Complaints{"4:22 E0305 'mass' of body 'arm' cannot be -3"});
}

TEST(WeightBinder, WarnsOfGravityThatActsOnNothing) {
  EXPECT_EQ(complaints_of_arm("{inertia: 1}", "gravity: [0, -9.81]\n"),
            Complaints{"6:1 W0301 gravity acts on no body, because none has a mass"});
}

TEST(WeightBinder, WarnsOfBareGravityInUnitsThatMakeItTiny) {
  const std::string millimetres = "units: {length: mm}\n";
  const std::string body = "{mass: 1, centre_of_mass: [1, 0]}";

  EXPECT_EQ(complaints_of_arm(body, millimetres + "gravity: [0, -9.81]\n"),
            Complaints{"7:1 W0304 gravity is 0.00981 m/s^2, because bare numbers count in mm/s^2"});
  EXPECT_EQ(complaints_of_arm(body, millimetres + "gravity: [0, -9.81 mm/s^2]\n"), Complaints{});
  EXPECT_EQ(complaints_of_arm(body, millimetres + "gravity: [0, -9810]\n"), Complaints{});
  EXPECT_EQ(complaints_of_arm(body, "gravity: [0, -1.62]\n"), Complaints{});
  EXPECT_EQ(complaints_of_arm(body, "gravity: [0, 0]\n"), Complaints{});
}

TEST(WeightBinder, WantsAnAccelerationAndALength) {
  EXPECT_EQ(complaints_of_arm("{mass: 1, centre_of_mass: [1 kg, 0]}", "gravity: [0, -9.81 mm]\n"),
            (Complaints{"4:42 E0309 expected a length, found a mass",
                        "6:14 E0309 expected an acceleration, found a length"}));
}

}  // namespace
}  // namespace kinestat
