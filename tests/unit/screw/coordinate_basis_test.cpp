#include "screw/coordinate_basis.hpp"

#include <gtest/gtest.h>

#include "screw/wrench.hpp"
#include "support/near.hpp"

namespace kinestat {
namespace {

Mat6X twists(const std::vector<Twist>& list) {
  Mat6X result(6, static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i) {
    result.col(static_cast<Eigen::Index>(i)) = list[i].coordinates();
  }
  return result;
}

// Rotations about parallel axes at three points that are not on one line.
Mat6X parallel_rotations(const Vec3& direction) {
  const Vec3 axis = direction.normalized();
  return twists({unit_rotation(axis, {0.0, 0.0, 0.0}),
                 unit_rotation(axis, {1.0, 0.0, 0.5}),
                 unit_rotation(axis, {0.0, 0.3, 2.0})});
}

TEST(CoordinateBasis, OfRotationsAboutZIsWzVxVy) {
  const CoordinateBasis basis =
      find_minimal_basis(parallel_rotations(Vec3::UnitZ()), ScrewKind::twist, 1.0);

  EXPECT_EQ(basis.coordinates, (std::vector<int>{2, 3, 4}));
  EXPECT_EQ(row_names(basis, ScrewKind::twist), (std::vector<std::string>{"wz", "vx", "vy"}));
}

// The Ravigneaux train: all pitch points in the plane x = 0 (Cazangi 2008, section 5.3).
TEST(CoordinateBasis, OfRotationsAboutZInThePlaneXZeroIsWzVx) {
  const Mat6X screws = twists({unit_rotation(Vec3::UnitZ(), {0.0, 0.0, 0.0}),
                               unit_rotation(Vec3::UnitZ(), {0.0, 17.0, 40.0})});

  const CoordinateBasis basis = find_minimal_basis(screws, ScrewKind::twist, 1.0);

  EXPECT_EQ(basis.coordinates, (std::vector<int>{2, 3}));
}

TEST(CoordinateBasis, OfParallelAxesAlongADiagonalIsObliqueOfOrderThree) {
  const CoordinateBasis basis =
      find_minimal_basis(parallel_rotations({1.0, 1.0, 0.0}), ScrewKind::twist, 1.0);

  EXPECT_EQ(basis.order(), 3);
  EXPECT_FALSE(basis.is_made_of_coordinates());
  EXPECT_EQ(row_names(basis, ScrewKind::twist), (std::vector<std::string>{"s1", "s2", "s3"}));
}

TEST(CoordinateBasis, OfAnObliqueSpanHoldsEveryScrew) {
  const Mat6X screws = parallel_rotations({1.0, 1.0, 0.0});

  const CoordinateBasis basis = find_minimal_basis(screws, ScrewKind::twist, 1.0);

  EXPECT_TRUE(is_near(basis.basis * (basis.basis.transpose() * screws), screws, kTight));
  EXPECT_TRUE(is_near(basis.basis.transpose() * basis.basis, MatX::Identity(3, 3), kTight));
}

TEST(CoordinateBasis, OfNoScrewsIsEmpty) {
  const CoordinateBasis basis = find_minimal_basis(Mat6X(6, 0), ScrewKind::twist, 1.0);

  EXPECT_EQ(basis.order(), 0);
  EXPECT_TRUE(row_names(basis, ScrewKind::twist).empty());
}

TEST(CoordinateBasis, OfAllSixUnitScrewsIsTheSpatialOne) {
  const CoordinateBasis basis = find_minimal_basis(Mat6X::Identity(6, 6), ScrewKind::wrench, 1.0);

  EXPECT_EQ(basis.coordinates, spatial_basis(ScrewKind::twist, 1.0).coordinates);
  EXPECT_EQ(row_names(basis, ScrewKind::wrench),
            (std::vector<std::string>{"Tx", "Ty", "Tz", "Fx", "Fy", "Fz"}));
}

// Points a micrometre apart, where moments are a millionth of the forces.
TEST(CoordinateBasis, DoesNotDependOnTheSizeOfTheMechanism) {
  Mat6X screws = parallel_rotations(Vec3::UnitZ());
  screws.bottomRows<3>() *= 1e-6;

  EXPECT_EQ(find_minimal_basis(screws, ScrewKind::twist, 1e-6).coordinates,
            (std::vector<int>{2, 3, 4}));
}

// A slide beside rotations, in a mechanism of 20 pm and in one of 40 million km.
TEST(CoordinateBasis, HoldsRotationsAndTranslationsOfMechanismsOfAnySize) {
  for (const double size : {2e-11, 4e10}) {
    const Mat6X screws = twists({unit_rotation(Vec3::UnitZ(), {0.0, 0.0, 0.0}),
                                 unit_rotation(Vec3::UnitZ(), {size, 0.5 * size, 0.0}),
                                 {.angular = Vec3::Zero(), .linear = Vec3::UnitX()}});

    const CoordinateBasis basis = find_minimal_basis(screws, ScrewKind::twist, size);

    EXPECT_EQ(basis.coordinates, (std::vector<int>{2, 3, 4})) << size;
  }
}

TEST(CoordinateBasis, HoldsForcesAndCouplesOfMechanismsOfAnySize) {
  for (const double size : {2e-11, 4e10}) {
    Mat6X screws = Mat6X::Zero(6, 3);
    screws.col(0)[2] = 1.0;
    screws.col(1)[3] = 1.0;
    screws.col(2)[4] = 1.0;
    screws.col(2)[2] = size;

    const CoordinateBasis basis = find_minimal_basis(screws, ScrewKind::wrench, size);

    EXPECT_EQ(basis.coordinates, (std::vector<int>{2, 3, 4})) << size;
  }
}

TEST(CoordinateBasis, OfThePlaneIsWzVxVyAndTzFxFy) {
  EXPECT_EQ(row_names(planar_basis(ScrewKind::twist, 1.0), ScrewKind::twist),
            (std::vector<std::string>{"wz", "vx", "vy"}));
  EXPECT_EQ(row_names(planar_basis(ScrewKind::twist, 1.0), ScrewKind::wrench),
            (std::vector<std::string>{"Tz", "Fx", "Fy"}));
}

}  // namespace
}  // namespace kinestat
