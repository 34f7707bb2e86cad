#include "math/dense/interpolation.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

const std::vector<double> kAt = {0.0, 0.1, 0.25, 0.45, 0.6};
const std::vector<double> kValues = {0.0, 0.2, 0.9, 1.4, 1.5};

void expect_point(SplineEnds ends, double x, double value, double slope, double bend) {
  const CurvePoint point = interpolated(kAt, kValues, spline_slopes(kAt, kValues, ends), x);

  EXPECT_NEAR(point.value, value, 1e-13);
  EXPECT_NEAR(point.slope, slope, 1e-12);
  EXPECT_NEAR(point.bend, bend, 1e-11);
}

// Moments by a tridiagonal system in 40 digits, and CubicSpline of SciPy.
TEST(CubicSpline, BeginsAndEndsAtRest) {
  expect_point(SplineEnds::rest, 0.05, 0.053164106939704206, 2.0632821387940843, 37.46871444823663);
  expect_point(SplineEnds::rest, 0.33, 1.1745720136518771, 2.683481228668942, -16.59613196814562);
  expect_point(SplineEnds::rest, 0.6, 1.5, 0.0, -9.806598407281001);
}

// Likewise.
TEST(CubicSpline, HasNoBendAtNaturalEnds) {
  expect_point(SplineEnds::natural, 0.0, 0.0, 1.3440860215053763, 0.0);
  expect_point(SplineEnds::natural, 0.52, 1.459131182795699, 0.634731182795699, -4.645161290322581);
}

// Likewise.
TEST(CubicSpline, GoesOnAsItBegan) {
  const std::vector<double> at = {0.0, 0.2, 0.5, 0.7, 1.0};
  const std::vector<double> values = {0.1, 0.6, 0.3, -0.2, 0.1};
  const std::vector<double> slopes = spline_slopes(at, values, SplineEnds::periodic);

  const CurvePoint first = interpolated(at, values, slopes, 0.0);
  const CurvePoint last = interpolated(at, values, slopes, 1.0);
  const CurvePoint between = interpolated(at, values, slopes, 0.33);

  EXPECT_NEAR(first.slope, 2.712121212121212, 1e-13);
  EXPECT_NEAR(first.bend, 6.96969696969697, 1e-12);
  EXPECT_NEAR(last.slope, first.slope, 1e-13);
  EXPECT_NEAR(last.bend, first.bend, 1e-12);
  EXPECT_NEAR(between.value, 0.6239558922558922, 1e-14);
  EXPECT_NEAR(between.slope, -0.8850505050505051, 1e-13);
}

// s'' of a cubic with s(0) = s(2) = 0, s(1) = 1 and period 2: by symmetry no slope at either point.
TEST(CubicSpline, OfTwoPointsThatGoRoundHasNoSlopeAtThem) {
  const std::vector<double> at = {0.0, 1.0, 2.0};
  const std::vector<double> values = {0.0, 1.0, 0.0};

  const std::vector<double> slopes = spline_slopes(at, values, SplineEnds::periodic);

  EXPECT_NEAR(slopes[0], 0.0, 1e-15);
  EXPECT_NEAR(slopes[1], 0.0, 1e-15);
  EXPECT_NEAR(interpolated(at, values, slopes, 0.5).value, 0.5, 1e-15);
}

TEST(MonotoneCubic, NeverPassesTheValuesOfItsNeighbours) {
  const std::vector<double> at = {0.0, 1.0, 2.0, 2.5, 4.0};
  const std::vector<double> values = {0.0, 0.0, 5.0, 5.1, 9.0};
  const std::vector<double> slopes = monotone_slopes(at, values, false);
  double before = 0.0;

  for (int i = 0; i <= 400; ++i) {
    const CurvePoint point = interpolated(at, values, slopes, 0.01 * i);
    EXPECT_GE(point.value, before - 1e-15) << i;
    EXPECT_GE(point.slope, -1e-13) << i;
    before = point.value;
  }
}

TEST(Interpolation, GoesOnBeyondItsEnds) {
  const std::vector<double> at = {1.0, 2.0, 4.0, 5.0};

  EXPECT_EQ(interval_of(at, 0.5), 0U);
  EXPECT_EQ(interval_of(at, 1.0), 0U);
  EXPECT_EQ(interval_of(at, 2.0), 1U);
  EXPECT_EQ(interval_of(at, 5.0), 2U);
  EXPECT_EQ(interval_of(at, 6.0), 2U);
}

TEST(Interpolation, OfStraightLinesHasTheSlopeBehindAPoint) {
  const std::vector<double> at = {0.0, 1.0, 3.0};
  const std::vector<double> values = {0.0, 2.0, 0.0};

  EXPECT_EQ(interpolated(at, values, {}, 1.0).slope, -1.0);
  EXPECT_EQ(interpolated(at, values, {}, 3.0).slope, -1.0);
  EXPECT_EQ(interpolated(at, values, {}, 0.25).value, 0.5);
}

// By differences of the value and of the slope.
TEST(Interpolation, HasTheDerivativesOfItsValue) {
  const std::vector<double> slopes = spline_slopes(kAt, kValues, SplineEnds::natural);
  constexpr double kStep = 1e-5;

  for (const double x : {0.03, 0.2, 0.4, 0.55}) {
    const CurvePoint before = interpolated(kAt, kValues, slopes, x - kStep);
    const CurvePoint point = interpolated(kAt, kValues, slopes, x);
    const CurvePoint behind = interpolated(kAt, kValues, slopes, x + kStep);
    EXPECT_NEAR((behind.value - before.value) / (2.0 * kStep), point.slope, 1e-7) << x;
    EXPECT_NEAR((behind.slope - before.slope) / (2.0 * kStep), point.bend, 1e-7) << x;
  }
}

}  // namespace
}  // namespace kinestat
