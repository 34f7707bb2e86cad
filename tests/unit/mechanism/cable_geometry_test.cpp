
#include "couplings/cable_geometry.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kClose = 1e-12;

// Positive radii turn about +z.
CableStationGeometry circle(const Vec3& centre, double radius) {
  return {.centre = centre, .axis = Vec3::UnitZ(), .radius = radius, .meets = {}, .leaves = {}};
}

CableStationGeometry point(const Vec3& at) {
  return circle(at, 0.0);
}

struct Belt {
  CableSpan there;
  CableSpan back;
  double wrap_a = 0.0;
  double wrap_b = 0.0;
};

Belt run(const CableStationGeometry& a, const CableStationGeometry& b) {
  Belt belt{.there = tangent_span<double>(a, b), .back = tangent_span<double>(b, a)};
  belt.wrap_a = wrap_angle<double>(a, belt.back, belt.there);
  belt.wrap_b = wrap_angle<double>(b, belt.there, belt.back);
  return belt;
}

double length(const CableSpan& span) {
  return (span.to - span.from).norm();
}

// Whether the segment touches the circle at the end `at`, moving in the sense of its radius.
void expect_tangent(const CableStationGeometry& on, const Vec3& at, const CableSpan& span) {
  const Vec3 along = (span.to - span.from).normalized();
  EXPECT_NEAR((at - on.centre).norm(), std::abs(on.radius), kClose);
  EXPECT_NEAR((at - on.centre).dot(along), 0.0, kClose);
  EXPECT_GT(on.axis.cross(at - on.centre).dot(along) * on.radius, 0.0);
}

TEST(TangentSpan, OfAnOpenBeltHasTheClosedForm) {
  // Contact angles π ± 2 asin((r2 - r1)/c), length √(c² - (r2 - r1)²).
  const double r1 = 0.4;
  const double r2 = 0.9;
  const double c = 3.0;
  const auto a = circle({1.0, 2.0, 0.0}, -r1);
  const auto b = circle({1.0 + c, 2.0, 0.0}, -r2);

  const Belt belt = run(a, b);

  EXPECT_NEAR(length(belt.there), std::sqrt(c * c - (r2 - r1) * (r2 - r1)), kClose);
  EXPECT_NEAR(length(belt.back), length(belt.there), kClose);
  EXPECT_NEAR(belt.wrap_a, kPi - 2.0 * std::asin((r2 - r1) / c), kClose);
  EXPECT_NEAR(belt.wrap_b, kPi + 2.0 * std::asin((r2 - r1) / c), kClose);
  expect_tangent(a, belt.there.from, belt.there);
  expect_tangent(b, belt.there.to, belt.there);
}

TEST(TangentSpan, OfACrossedBeltHasTheClosedForm) {
  // Both contact angles π + 2 asin((r1 + r2)/c), length √(c² - (r1 + r2)²).
  const double r1 = 0.4;
  const double r2 = 0.9;
  const double c = 3.0;
  const auto a = circle({0.0, 0.0, 0.0}, r1);
  const auto b = circle({0.0, c, 0.0}, -r2);

  const Belt belt = run(a, b);

  EXPECT_NEAR(length(belt.there), std::sqrt(c * c - (r1 + r2) * (r1 + r2)), kClose);
  EXPECT_NEAR(belt.wrap_a, kPi + 2.0 * std::asin((r1 + r2) / c), kClose);
  EXPECT_NEAR(belt.wrap_b, belt.wrap_a, kClose);
  expect_tangent(a, belt.there.from, belt.there);
  expect_tangent(b, belt.there.to, belt.there);
  expect_tangent(b, belt.back.from, belt.back);
}

TEST(TangentSpan, FromAPointTouchesTheSideOfTheWrap) {
  // Cables that hang from both sides of a pulley (Alves 2023, Fig. 3.31: r = 3, d = 6, h = 10).
  const auto pulley = circle({3.0, 10.0, 0.0}, -3.0);

  const CableSpan up = tangent_span<double>(point({0.0, 0.0, 0.0}), pulley);
  const CableSpan down = tangent_span<double>(pulley, point({6.0, 0.0, 0.0}));

  EXPECT_LE((up.to - Vec3(0.0, 10.0, 0.0)).norm(), kClose);
  EXPECT_LE((down.from - Vec3(6.0, 10.0, 0.0)).norm(), kClose);
  EXPECT_NEAR(wrap_angle<double>(pulley, up, down), kPi, kClose);
}

TEST(TangentSpan, IsTheSameInADrawingThatIsTurnedAndMoved) {
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.7, Vec3::UnitX()) * Eigen::AngleAxisd(2.1, Vec3::UnitZ()))
          .toRotationMatrix();
  const Vec3 shift(5.0, -3.0, 2.0);
  auto a = circle({0.3, 0.1, 0.0}, 0.5);
  auto b = circle({2.0, 1.2, 0.0}, -0.8);
  const Belt drawn = run(a, b);
  for (CableStationGeometry* station : {&a, &b}) {
    station->centre = turn * station->centre + shift;
    station->axis = turn * station->axis;
  }

  const Belt moved = run(a, b);

  EXPECT_LE((moved.there.from - (turn * drawn.there.from + shift)).norm(), kClose);
  EXPECT_LE((moved.there.to - (turn * drawn.there.to + shift)).norm(), kClose);
  EXPECT_NEAR(moved.wrap_a, drawn.wrap_a, kClose);
  EXPECT_NEAR(moved.wrap_b, drawn.wrap_b, kClose);
}

TEST(TangentSpan, TurnsAboutTheAxisOfEachPulley) {
  const auto a = circle({0.0, 0.0, 0.0}, 0.5);
  const auto b = circle({2.0, 0.0, 0.0}, -0.8);
  auto reversed = b;
  reversed.axis = -Vec3::UnitZ();
  reversed.radius = 0.8;

  EXPECT_LE((tangent_span<double>(a, reversed).to - tangent_span<double>(a, b).to).norm(), kClose);
  EXPECT_NEAR(run(a, reversed).wrap_b, run(a, b).wrap_b, kClose);
}

TEST(TangentSpan, BeginsAndEndsAtThePointsThatAreGiven) {
  auto given = circle({3.0, 10.0, 0.0}, -3.0);
  given.meets = Vec3(0.0, 10.0, 0.0);
  given.leaves = Vec3(3.0, 13.0, 0.0);
  const auto next = circle({9.0, 10.0, 0.0}, -3.0);

  const CableSpan there = tangent_span<double>(point({0.0, 0.0, 0.0}), given);
  const CableSpan on = tangent_span<double>(given, next);

  EXPECT_EQ(there.to, Vec3(0.0, 10.0, 0.0));
  EXPECT_LE((on.from - Vec3(3.0, 13.0, 0.0)).norm(), kClose);
  EXPECT_LE((on.to - Vec3(9.0, 13.0, 0.0)).norm(), kClose);
  EXPECT_NEAR(wrap_angle<double>(given, there, on), kPi / 2.0, kClose);
}

TEST(WrapAngle, OfARopeThatRunsStraightPastIsZero) {
  const auto pulley = circle({0.3, 0.1 - 1.0, 0.0}, -1.0);
  const CableSpan before = tangent_span<double>(point({-0.7, 0.1, 0.0}), pulley);
  const CableSpan after = tangent_span<double>(pulley, point({1.9, 0.1, 0.0}));

  EXPECT_NEAR(wrap_angle<double>(pulley, before, after), 0.0, kClose);
}

TEST(WrapAngle, IsMoreThanHalfATurnWhereTheRopeComesBack) {
  // Down and up again around a capstan: three quarters of a turn.
  const auto pulley = circle({0.0, 0.0, 0.0}, 1.0);
  const CableSpan before = tangent_span<double>(point({1.0, -5.0, 0.0}), pulley);
  const CableSpan after = tangent_span<double>(pulley, point({5.0, -1.0, 0.0}));

  EXPECT_NEAR(wrap_angle<double>(pulley, before, after), 1.5 * kPi, kClose);
}

TEST(TangentSpan, CarriesDerivatives) {
  // Of r_a, r_b and the three coordinates that matter, against central differences.
  const double at[5] = {0.4, -0.9, 3.0, 0.5, -0.2};
  const auto stations = [](const auto& x) {
    using Scalar = std::decay_t<decltype(x[0])>;
    CableStationGeometryOf<Scalar> a;
    CableStationGeometryOf<Scalar> b;
    a.radius = x[0];
    a.centre[0] = x[4];
    b.radius = x[1];
    b.centre[0] = x[2];
    b.centre[1] = x[3];
    return std::pair(a, b);
  };
  const auto values = [&](const auto& x) {
    using Scalar = std::decay_t<decltype(x[0])>;
    const auto [a, b] = stations(x);
    const auto there = tangent_span<Scalar>(a, b);
    const auto back = tangent_span<Scalar>(b, a);
    return std::array<Scalar, 5>{there.from[0],
                                 there.from[1],
                                 there.to[1],
                                 wrap_angle<Scalar>(a, back, there),
                                 wrap_angle<Scalar>(b, there, back)};
  };
  std::array<Dual, 5> duals;
  for (std::size_t i = 0; i < 5; ++i) {
    duals[i] = make_variable(at[i], i, 5);
  }

  const std::array<Dual, 5> found = values(duals);

  constexpr double kStep = 1e-6;
  for (std::size_t i = 0; i < 5; ++i) {
    std::array<double, 5> low = {at[0], at[1], at[2], at[3], at[4]};
    std::array<double, 5> high = low;
    low[i] -= kStep;
    high[i] += kStep;
    for (std::size_t k = 0; k < 5; ++k) {
      const double difference = (values(high)[k] - values(low)[k]) / (2.0 * kStep);
      EXPECT_NEAR(derivative(found[k], i), difference, 1e-8) << "value " << k << " variable " << i;
    }
  }
}

TEST(SpanFault, SaysWhyThereIsNoTangent) {
  using enum SpanFault;
  const auto a = circle({0.0, 0.0, 0.0}, 1.0);

  EXPECT_EQ(find_fault(point({1.0, 2.0, 0.0}), point({1.0, 2.0, 0.0})), same_point);
  EXPECT_EQ(find_fault(a, point({0.5, 0.0, 0.0})), point_inside);
  EXPECT_EQ(find_fault(point({0.6, 0.8, 0.0}), a), point_inside);
  EXPECT_EQ(find_fault(a, circle({1.5, 0.0, 0.0}, 3.0)), circle_inside);
  EXPECT_EQ(find_fault(a, circle({1.5, 0.0, 0.0}, -1.0)), overlap);
  EXPECT_EQ(find_fault(a, circle({1.5, 0.0, 0.0}, 1.0)), none);
  EXPECT_EQ(find_fault(a, point({3.0, 0.0, 0.5})), out_of_plane);
  EXPECT_EQ(find_fault(a, a), circle_inside);
}

TEST(SpanFault, OfPulleysWithObliqueAxesIsThePlane) {
  auto oblique = circle({3.0, 0.0, 0.0}, 1.0);
  oblique.axis = Vec3(0.0, 0.6, 0.8);

  EXPECT_EQ(find_fault(circle({0.0, 0.0, 0.0}, 1.0), oblique), SpanFault::out_of_plane);
}

TEST(PassesThrough, WhatComesNearerThanTheRadiusInThePlaneOfThePulley) {
  const CableSpan span = {.from = Vec3(-2.0, 0.0, 0.0), .to = Vec3(2.0, 0.0, 0.0)};

  EXPECT_TRUE(passes_through(span, circle({0.0, 0.9, 0.0}, 1.0), 1e-9));
  EXPECT_FALSE(passes_through(span, circle({0.0, 1.0, 0.0}, 1.0), 1e-9));
  EXPECT_FALSE(passes_through(span, circle({3.5, 0.0, 0.0}, 1.0), 1e-9));
  EXPECT_TRUE(passes_through(span, circle({2.5, 0.0, 0.0}, 1.0), 1e-9));
  EXPECT_FALSE(passes_through(span, circle({0.0, 0.0, 0.5}, 1.0), 1e-9));
  EXPECT_FALSE(passes_through(span, circle({0.0, 0.999, 0.0}, 1.0), 0.01));
}

}  // namespace
}  // namespace kinestat
