#include "power/transmission_angle.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/mechanism_text.hpp"

namespace kinestat {
namespace {

constexpr double kTight = 1e-14;

std::string four_bar(const std::string& c) {
  return "space: planar\nground: frame\nbodies: [crank, coupler, rocker]\ncouplings:\n"
         "  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}\n"
         "  b: {type: revolute, bodies: [crank, coupler], at: [1, 3]}\n"
         "  c: {type: revolute, bodies: [coupler, rocker], at: [" +
         c +
         "]}\n  d: {type: revolute, bodies: [frame, rocker], at: [7, 0]}\n"
         "actuators: {Tin: {coupling: a}, Tout: {coupling: d}}\n";
}

TEST(TransmissionAngle, IsThatBetweenCouplerAndRockerInAFourBar) {
  // c - b = (5, 2), c - d = (-1, 5): cos = 5/sqrt(29·26).
  const Mechanism mechanism = mechanism_of(four_bar("6, 5"));

  EXPECT_NEAR(find_transmission_angle(mechanism, 0, 1).value(),
              std::acos(5.0 / std::sqrt(29.0 * 26.0)),
              kTight);
}

TEST(TransmissionAngle, LooksAtTheCrankWhereTheRockerDrives) {
  // b - c = (-5, -2), b - a = (1, 3): cos = 11/sqrt(29·10).
  const Mechanism mechanism = mechanism_of(four_bar("6, 5"));

  EXPECT_NEAR(find_transmission_angle(mechanism, 1, 0).value(),
              std::acos(11.0 / std::sqrt(29.0 * 10.0)),
              kTight);
}

TEST(TransmissionAngle, IsZeroWhereCouplerAndRockerAreInLine) {
  const Mechanism mechanism = mechanism_of(four_bar("4, 1.5"));  // the middle of b and d

  EXPECT_NEAR(find_transmission_angle(mechanism, 0, 1).value(), 0.0, kTight);
}

// At the change point of a parallelogram, where all links lie in one line, neither crank nor rocker
// bears a torque.
TEST(TransmissionAngle, IsZeroWhereAllLinksAreInLine) {
  const Mechanism mechanism = mechanism_of(
      "space: planar\nground: frame\nbodies: [crank, coupler, rocker]\ncouplings:\n"
      "  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}\n"
      "  b: {type: revolute, bodies: [crank, coupler], at: [3, 4]}\n"
      "  c: {type: revolute, bodies: [coupler, rocker], at: [9, 12]}\n"
      "  d: {type: revolute, bodies: [frame, rocker], at: [6, 8]}\n"
      "actuators: {Tin: {coupling: a}, Tout: {coupling: d}}\n");

  EXPECT_NEAR(find_transmission_angle(mechanism, 0, 1).value(), 0.0, kTight);
}

// A rocker a billionth as long as the other links moves its end all the same: d - c = (0, -1),
// c - b = (6, -3).
TEST(TransmissionAngle, ExistsHoweverShortTheRocker) {
  const Mechanism mechanism = mechanism_of(four_bar("7, 5e-9"));

  EXPECT_NEAR(find_transmission_angle(mechanism, 0, 1).value(), std::atan2(6.0, 3.0), 1e-5);
}

TEST(TransmissionAngle, DoesNotExistWhereTheForceGoesThroughTheAxis) {
  const Mechanism mechanism = mechanism_of(four_bar("7, 0"));

  EXPECT_EQ(find_transmission_obstacle(mechanism, 0, 1), TransmissionObstacle::rest);
}

TEST(TransmissionAngle, IsThatOfTheRodToTheNormalOfTheSlide) {
  // The rod from (9, 12) to (14, 0): its angle to the slide's x has the tangent 12/5.
  const Mechanism mechanism = mechanism_of(kSliderCrank);

  EXPECT_NEAR(find_transmission_angle(mechanism, 0, 1).value(),
              std::numbers::pi / 2.0 - std::atan2(12.0, 5.0),
              kTight);
}

TEST(TransmissionAngle, DoesNotExistWhereTwoCouplingsDriveTheOutput) {
  const Mechanism mechanism = mechanism_of(
      "space: planar\nground: frame\nbodies: [crank, coupler, link, rocker]\ncouplings:\n"
      "  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}\n"
      "  b: {type: revolute, bodies: [crank, coupler], at: [0, 2]}\n"
      "  c: {type: revolute, bodies: [coupler, rocker], at: [3, 2]}\n"
      "  e: {type: revolute, bodies: [crank, link], at: [0, 1]}\n"
      "  f: {type: revolute, bodies: [link, rocker], at: [3, 1]}\n"
      "  d: {type: revolute, bodies: [frame, rocker], at: [3, 0]}\n"
      "actuators: {Tin: {coupling: a}, Tout: {coupling: d}}\n");

  EXPECT_FALSE(find_transmission_angle(mechanism, 0, 1));
  EXPECT_EQ(find_transmission_obstacle(mechanism, 0, 1), TransmissionObstacle::no_one_coupling);
}

TEST(TransmissionAngle, DoesNotExistWhereBearingsMayPressAlongTheirAxes) {
  const Mechanism mechanism = mechanism_of(
      "ground: frame\nbodies: [crank, coupler, rocker]\ncouplings:\n"
      "  a: {type: revolute, bodies: [frame, crank], at: [0, 0, 0], axis: z}\n"
      "  b: {type: revolute, bodies: [crank, coupler], at: [1, 3, 0], axis: z}\n"
      "  c: {type: revolute, bodies: [coupler, rocker], at: [6, 5, 0], axis: z}\n"
      "  d: {type: revolute, bodies: [frame, rocker], at: [7, 0, 0], axis: z}\n"
      "actuators: {Tin: {coupling: a}, Tout: {coupling: d}}\n");

  EXPECT_EQ(find_transmission_obstacle(mechanism, 0, 1), TransmissionObstacle::open_force);
  EXPECT_EQ(find_transmission_obstacle(mechanism, 0, 0), TransmissionObstacle::same_actuator);
}

TEST(TransmissionAngle, ExistsWhereNothingIsInItsWay) {
  const Mechanism mechanism = mechanism_of(four_bar("6, 5"));

  EXPECT_FALSE(find_transmission_obstacle(mechanism, 0, 1));
}

}  // namespace
}  // namespace kinestat
