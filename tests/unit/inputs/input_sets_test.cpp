#include "studies/inputs/input_sets.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "network/bases.hpp"
#include "studies/inputs/solution_space.hpp"
#include "support/mechanism_text.hpp"

namespace kinestat {
namespace {

using Set = std::vector<int>;

// Laplace's expansion: exact for small whole numbers.
double determinant(const MatX& matrix) {
  if (matrix.rows() == 0) {
    return 1.0;
  }
  double sum = 0.0;
  for (Eigen::Index c = 0; c < matrix.cols(); ++c) {
    if (matrix(0, c) == 0.0) {
      continue;
    }
    Set others;
    for (int other = 0; other < matrix.cols(); ++other) {
      if (other != c) {
        others.push_back(other);
      }
    }
    const MatX minor = matrix(Eigen::seq(1, Eigen::last), others);
    sum += (c % 2 == 0 ? 1.0 : -1.0) * matrix(0, c) * determinant(minor);
  }
  return sum;
}

// Every choice of as many rows as there are columns, whose determinant is not zero.
std::set<Set> tried_one_by_one(const MatX& solutions) {
  const int rows = static_cast<int>(solutions.rows());
  const int needed = static_cast<int>(solutions.cols());
  std::set<Set> found;
  for (std::uint32_t bits = 0; bits < (1U << static_cast<unsigned>(rows)); ++bits) {
    Set chosen;
    for (int r = 0; r < rows; ++r) {
      if ((bits >> static_cast<unsigned>(r) & 1U) != 0) {
        chosen.push_back(r);
      }
    }
    if (static_cast<int>(chosen.size()) == needed &&
        determinant(solutions(chosen, Eigen::all)) != 0.0) {
      found.insert(chosen);
    }
  }
  return found;
}

// One set of each group, in all combinations.
std::set<Set> combined(const InputSets& sets) {
  std::set<Set> all = {{}};
  for (const InputGroup& group : sets.groups) {
    std::set<Set> longer;
    for (const Set& begun : all) {
      for (const InputSet& one : group.best) {
        Set both = begun;
        both.insert(both.end(), one.magnitudes.begin(), one.magnitudes.end());
        std::ranges::sort(both);
        longer.insert(both);
      }
    }
    all = std::move(longer);
  }
  return all;
}

MatX random_solutions(std::mt19937& random) {
  std::uniform_int_distribution<int> rows(1, 9);
  std::uniform_int_distribution<int> entry(-3, 3);
  const int count = rows(random);
  MatX result(count, std::uniform_int_distribution<int>(1, std::min(count, 4))(random));
  for (double& x : result.reshaped()) {
    x = std::max(0, std::abs(entry(random)) - 1) * (entry(random) < 0 ? -1.0 : 1.0);
  }
  return result;
}

TEST(InputSets, AreAllChoicesWithADeterminant) {
  std::mt19937 random(20261121);
  int compared = 0;
  for (int i = 0; i < 2000; ++i) {
    const MatX solutions = random_solutions(random);
    const std::set<Set> expected = tried_one_by_one(solutions);
    if (expected.empty()) {
      continue;  // the columns are dependent: no basis of solutions
    }
    const InputSets found =
        find_input_sets(solutions, {.among = {}, .required = {}, .listed = 1000});
    ASSERT_EQ(combined(found), expected) << solutions;
    EXPECT_EQ(found.count(), expected.size());
    EXPECT_TRUE(found.is_complete());
    ++compared;
  }
  EXPECT_GT(compared, 500);
}

// The determinant of the rows in an orthonormal basis lies between the powers of its singular
// values; for one solution it is the share of the magnitude itself.
TEST(InputSets, AreRankedByTheirSmallestSingularValue) {
  const MatX solution = (MatX(3, 1) << 3.0, 0.0, -4.0).finished();

  const InputSets found = find_input_sets(solution);

  ASSERT_EQ(found.groups.size(), 1U);
  EXPECT_EQ(found.always_zero, (Set{1}));
  ASSERT_EQ(found.groups[0].best.size(), 2U);
  EXPECT_EQ(found.groups[0].best[0].magnitudes, (Set{2}));
  EXPECT_NEAR(found.groups[0].best[0].conditioning, 0.8, 1e-15);
  EXPECT_NEAR(found.groups[0].best[1].conditioning, 0.6, 1e-15);
}

// Two unit vectors at the angle α: the smallest singular value is √(1 - cos α), of whatever basis.
TEST(InputSets, ConditioningIsThatOfTheAngleBetweenTwoRows) {
  constexpr double kAngle = 0.3;
  MatX rows(4, 2);
  rows << 1.0, 0.0, std::cos(kAngle), std::sin(kAngle), 0.0, 1.0, -std::sin(kAngle),
      std::cos(kAngle);
  const MatX orthonormal = rows / std::sqrt(2.0);  // columns of length √2, perpendicular
  MatX mixing(2, 2);
  mixing << 2.0, 5.0, -1.0, 3.0;

  const double expected = std::sqrt((1.0 - std::cos(kAngle)) / 2.0);
  EXPECT_NEAR(conditioning_of(orthonormal, Set{0, 1}), expected, 1e-15);
  EXPECT_NEAR(conditioning_of(orthonormal * mixing, Set{0, 1}), expected, 1e-14);
}

TEST(InputSets, TakeOnlyWhatIsAllowedAndAllThatIsRequired) {
  MatX solutions(4, 2);
  solutions << 1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, -1.0;

  const InputSets among = find_input_sets(solutions, {.among = {0, 2, 3}, .required = {}});
  EXPECT_EQ(combined(among), (std::set<Set>{{0, 2}, {0, 3}, {2, 3}}));
  const InputSets with = find_input_sets(solutions, {.among = {}, .required = {3}});
  EXPECT_EQ(combined(with), (std::set<Set>{{0, 3}, {1, 3}, {2, 3}}));
  const InputSets both = find_input_sets(solutions, {.among = {0}, .required = {3}});
  EXPECT_EQ(combined(both), (std::set<Set>{{0, 3}}));
}

// Independent loops are chosen from one by one, so their sets are counted and not multiplied out.
TEST(InputSets, OfIndependentPartsAreGroups) {
  constexpr int kParts = 40;
  MatX solutions = MatX::Zero(3 * kParts, kParts);
  for (int i = 0; i < kParts; ++i) {
    solutions.col(i).segment(3 * i, 3).setOnes();
  }

  const InputSets found = find_input_sets(solutions);

  EXPECT_EQ(found.needed, kParts);
  EXPECT_EQ(found.groups.size(), static_cast<std::size_t>(kParts));
  EXPECT_EQ(found.groups[7].magnitudes, (Set{21, 22, 23}));
  EXPECT_EQ(found.groups[7].count, 3U);
  EXPECT_EQ(found.count(), kMostSets);  // 3^40 is more than the report can say
  EXPECT_FALSE(found.is_complete());
}

// Whoever writes one gearbox forty times into a file does not wait forty times as long: groups
// share what may be counted, and a small one among large ones is counted all the same.
TEST(InputSets, OfManyLargeGroupsAreCountedAsFarAsOfOne) {
  constexpr int kLarge = 7;
  constexpr int kHalf = 12;
  MatX solutions = MatX::Zero(kLarge * 2 * kHalf + 3, kLarge * kHalf + 1);
  std::mt19937 random(5);
  std::uniform_int_distribution<int> digits(-9, 9);
  for (int i = 0; i < kLarge; ++i) {
    for (int r = 0; r < 2 * kHalf; ++r) {
      for (int c = 0; c < kHalf; ++c) {
        solutions(2 * kHalf * i + r, kHalf * i + c) = digits(random);
      }
    }
  }
  solutions.col(kLarge * kHalf).tail(3).setOnes();

  const InputSets found = find_input_sets(solutions, {.among = {}, .required = {}, .listed = 0});

  ASSERT_EQ(found.groups.size(), static_cast<std::size_t>(kLarge) + 1);
  std::uint64_t counted = 0;
  for (const InputGroup& group : found.groups) {
    counted += group.count;
  }
  EXPECT_LE(counted, 10'000'000U);  // of 24 over 12, 2 704 156, seven times
  for (int i = 0; i < kLarge; ++i) {
    EXPECT_GT(found.groups[static_cast<std::size_t>(i)].count, 1'000'000U) << i;
    EXPECT_FALSE(found.groups[static_cast<std::size_t>(i)].is_complete) << i;
  }
  EXPECT_EQ(found.groups.back().count, 3U);
  EXPECT_TRUE(found.groups.back().is_complete);
  EXPECT_FALSE(found.is_complete());
}

TEST(InputSets, OfAMechanismThatCannotMoveAreOneThatIsEmpty) {
  const InputSets found = find_input_sets(MatX::Zero(3, 0));

  EXPECT_EQ(found.needed, 0);
  EXPECT_EQ(found.count(), 1U);
  EXPECT_EQ(found.always_zero, (Set{0, 1, 2}));
}

// The four-bar a, b, c, d of one freedom: any rate determines the others, and the sum of the turns
// about the circuit is zero.
TEST(SolutionSpace, OfAFourBarIsTheRatesOfItsMotion) {
  const Mechanism mechanism = mechanism_of(
      "space: planar\n"
      "ground: f\n"
      "bodies: [crank, coupler, rocker]\n"
      "couplings:\n"
      "  a: {type: revolute, bodies: [f, crank], at: [0, 0]}\n"
      "  b: {type: revolute, bodies: [crank, coupler], at: [1, 3]}\n"
      "  c: {type: revolute, bodies: [coupler, rocker], at: [6, 5]}\n"
      "  d: {type: revolute, bodies: [f, rocker], at: [7, 0]}\n");

  const SolutionSpace space =
      motion_space(mechanism, motion_basis(mechanism.geometry, OrderChoice::minimal));

  ASSERT_EQ(space.dimension(), 1);
  const VecX rates = space.basis.col(0) / space.basis(3, 0);
  EXPECT_NEAR(rates[0] + rates[1] + rates[2] - 1.0, 0.0, 1e-14);
  EXPECT_NEAR(rates[0], 27.0 / 13.0, 1e-14);  // v_c of the rocker is that of the coupler
  EXPECT_EQ(find_input_sets(space.basis).count(), 4U);
}

}  // namespace
}  // namespace kinestat
