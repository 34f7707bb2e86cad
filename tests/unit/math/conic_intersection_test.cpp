#include "math/dense/conic_intersection.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace kinestat {
namespace {

// x² + y² = r² z²
Mat3 circle(double radius) {
  return Vec3(1.0, 1.0, -radius * radius).asDiagonal();
}

// The two lines p . y = 0 and q . y = 0.
Mat3 line_pair(const Vec3& p, const Vec3& q) {
  return p * q.transpose() + q * p.transpose();
}

double nearest(const ConicIntersection& found, const Vec3& point) {
  double least = 2.0;
  for (const ConicPoint& one : found.points) {
    const Vec3 y = one.y.real();
    least = std::min(least, y.cross(point.normalized()).norm() + one.y.imag().norm());
  }
  return least;
}

// x² + y² = 1 and (x/2)² + (2y)² = 1: x² = 4/5, y² = 1/5.
TEST(ConicIntersection, OfACircleAndAnEllipseIsFourPoints) {
  const ConicIntersection found = intersect_conics(circle(1.0), Vec3(0.25, 4.0, -1.0).asDiagonal());

  ASSERT_EQ(found.points.size(), 4U);
  EXPECT_LT(nearest(found, Vec3(2.0 / std::sqrt(5.0), 1.0 / std::sqrt(5.0), 1.0)), 1e-14);
  EXPECT_LT(nearest(found, Vec3(-2.0 / std::sqrt(5.0), 1.0 / std::sqrt(5.0), 1.0)), 1e-14);
  EXPECT_LT(nearest(found, Vec3(2.0 / std::sqrt(5.0), -1.0 / std::sqrt(5.0), 1.0)), 1e-14);
  EXPECT_LT(nearest(found, Vec3(-2.0 / std::sqrt(5.0), -1.0 / std::sqrt(5.0), 1.0)), 1e-14);
}

// An ellipse inside the circle.
TEST(ConicIntersection, MayHaveNoRealPoint) {
  const ConicIntersection found = intersect_conics(circle(3.0), Vec3(0.25, 4.0, -1.0).asDiagonal());

  ASSERT_EQ(found.points.size(), 4U);
  EXPECT_TRUE(std::ranges::none_of(found.points, &ConicPoint::is_real));
}

// The circle (x - 2)² + y² = 1 touches the unit circle in (1, 0); the other two points are the
// circular ones, which are not real.
TEST(ConicIntersection, OfConicsThatTouchHasADoublePoint) {
  Mat3 moved = circle(1.0);
  moved(0, 2) = moved(2, 0) = -2.0;
  moved(2, 2) = 3.0;

  const ConicIntersection found = intersect_conics(circle(1.0), moved);

  ASSERT_EQ(found.points.size(), 3U);
  const auto touching = std::ranges::find(found.points, 2, &ConicPoint::multiplicity);
  ASSERT_NE(touching, found.points.end());
  EXPECT_TRUE(touching->is_real);
  EXPECT_LT(nearest(found, Vec3(1.0, 0.0, 1.0)), 1e-12);
}

TEST(ConicIntersection, TakesOutASharedLine) {
  const Vec3 line(0.3, -0.5, 1.0);
  const Vec3 p(1.0, 0.2, 0.4);
  const Vec3 q(-0.7, 0.9, 0.1);

  const ConicIntersection found = intersect_conics(line_pair(line, p), line_pair(line, q));

  EXPECT_EQ(found.shared, SharedPart::line);
  EXPECT_LT(found.shared_line.cross(line.normalized()).norm(), 1e-13);
  ASSERT_EQ(found.points.size(), 1U);
  EXPECT_LT(nearest(found, p.cross(q)), 1e-13);
}

TEST(ConicIntersection, OfOneConicWithItselfIsTheConic) {
  EXPECT_EQ(intersect_conics(circle(1.0), -2.0 * circle(1.0)).shared, SharedPart::conic);
}

// Conics through four given points: two line pairs through them span the pencil.
TEST(ConicIntersection, FindsTheFourPointsOfAPencil) {
  Random random(7);
  for (int i = 0; i < 500; ++i) {
    SCOPED_TRACE(i);
    const Vec3 p = random.direction();
    const Vec3 q = random.direction();
    const Vec3 r = random.direction();
    const Vec3 s = random.direction();
    const Mat3 first = line_pair(p.cross(q), r.cross(s));
    const Mat3 second = line_pair(p.cross(r), q.cross(s));

    const ConicIntersection found = intersect_conics(first + second, first - 0.5 * second);

    const double worst =
        std::max({nearest(found, p), nearest(found, q), nearest(found, r), nearest(found, s)});
    double condition = 0.0;
    for (const ConicPoint& one : found.points) {
      condition = std::max(condition, one.condition);
    }
    EXPECT_LT(worst, std::max(1e-14 * condition, 1e-13));
  }
}

}  // namespace
}  // namespace kinestat
