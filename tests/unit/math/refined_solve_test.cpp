#include "math/elimination/refined_solve.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "math/elimination/exact_elimination.hpp"
#include "support/random.hpp"
#include "unit/math/exact_value.hpp"
#include "unit/math/sparse.hpp"

namespace kinestat {
namespace {

// A chain of stages x_i = ratio x_(i - 1), driven with 1.
SparseMatrix chain(int stages, double ratio) {
  SparseMatrix matrix{.rows = stages, .columns = stages, .entries = {}};
  for (int i = 0; i < stages; ++i) {
    matrix.add(i, i, 1.0);
    if (i > 0) {
      matrix.add(i, i - 1, -ratio);
    }
  }
  return matrix;
}

std::vector<double> drive(int stages) {
  std::vector<double> rhs(static_cast<std::size_t>(stages), 0.0);
  rhs.front() = 1.0;
  return rhs;
}

TEST(RefinedSolve, OfNoEquationsHasNoUnknowns) {
  const Elimination factors(SparseMatrix{}, {});

  const RefinedSolve solve(factors, {}, {});

  EXPECT_TRUE(solve.x().empty());
  EXPECT_EQ(solve.error_bound()->size(), 0);
}

TEST(RefinedSolve, KeepsWhatIsKnownAndLeavesFreeColumnsZero) {
  SparseMatrix matrix{.rows = 1, .columns = 3, .entries = {}};
  matrix.add(0, 0, 3.0);
  matrix.add(0, 2, -1.0);
  const Elimination factors(matrix, std::vector<int>{2});

  RefinedSolve solve(factors, std::vector<double>{1.0}, {});
  solve.refine();

  const std::vector<DoubleDouble> x = solve.x();
  EXPECT_LE(abs(Rational(exact(x[0]) - Rational(1, 3))), *read_decimal("1e-31"));
  EXPECT_EQ(x[1], DoubleDouble{});
  EXPECT_EQ(x[2], (DoubleDouble{.high = 1.0, .low = 0.0}));
}

// The speed of the last of 80 stages is 3.5^79, a fraction of 222 bits.
TEST(RefinedSolve, FollowsAChainOfEightyStages) {
  const Elimination factors(chain(80, 3.5), {});

  RefinedSolve solve(factors, {}, drive(80));
  solve.refine();

  const Rational expected = *whole_power(Rational(7, 2), 79);
  const Rational error = abs(Rational(exact(solve.x().back()) - expected));
  EXPECT_LE(error, *read_decimal("1e-29") * expected);
  EXPECT_LE(error, Rational((*solve.error_bound())[79]));
}

TEST(RefinedSolve, HasNoBoundWhereNumbersOverflow) {
  SparseMatrix matrix{.rows = 1, .columns = 1, .entries = {}};
  matrix.add(0, 0, 1e-200);
  const Elimination factors(matrix, {});

  EXPECT_FALSE(RefinedSolve(factors, {}, std::vector<double>{1e200}).error_bound().has_value());
}

// 0.1 x = 1 with the double nearest to 0.1, which is no tenth: the answer is not 10.
TEST(RefinedSolve, SolvesForTheDoublesItIsGiven) {
  SparseMatrix matrix{.rows = 1, .columns = 1, .entries = {}};
  matrix.add(0, 0, 0.1);
  const Elimination factors(matrix, {});

  RefinedSolve solve(factors, {}, std::vector<double>{1.0});
  solve.refine();

  const Rational expected = 1 / Rational(0.1);
  EXPECT_NE(expected, 10);
  EXPECT_LE(abs(Rational(exact(solve.x()[0]) - expected)), *read_decimal("1e-30"));
}

// Families of systems

struct Family {
  const char* name;
  std::function<MatX(int size, Random& random)> make;
};

// About three entries a row, and the diagonal.
MatX random_with_diagonal(int size, Random& random) {
  MatX result = MatX::Zero(size, size);
  for (int r = 0; r < size; ++r) {
    for (int i = 0; i < 3; ++i) {
      result(r, random.whole(0, size - 1)) = random.magnitude();
    }
    result(r, r) += random.magnitude();
  }
  return result;
}

MatX random_dense(int size, Random& random) {
  return MatX::NullaryExpr(size, size, [&] { return random.between(-1.0, 1.0); });
}

double power_of_ten(double decades, Random& random) {
  return std::pow(10.0, random.between(-decades, decades));
}

MatX random_scales(int size, Random& random) {
  MatX result = random_with_diagonal(size, random);
  for (int i = 0; i < size; ++i) {
    result.row(i) *= power_of_ten(9.0, random);
    result.col(i) *= power_of_ten(3.0, random);
  }
  return result;
}

// The last row nearly combines others: by 1e-1 to 1e-9.
MatX nearly_singular(int size, Random& random) {
  MatX result = random_with_diagonal(size, random);
  VecX last = VecX::Zero(size);
  for (int i = 0; i < 3; ++i) {
    last += random.magnitude() * result.row(random.whole(0, size - 2)).transpose();
  }
  const double distance = std::pow(10.0, random.between(-9.0, -1.0));
  for (double& value : last) {
    value *= 1.0 + distance * random.between(-1.0, 1.0);
  }
  result.row(size - 1) = last.transpose();
  return result;
}

// Condition 1e3 to 1e10.
MatX small_hilbert(int size, Random& /*random*/) {
  const int order = 3 + size % 6;
  return MatX::NullaryExpr(
      order, order, [](Eigen::Index r, Eigen::Index c) { return 1.0 / double(r + c + 1); });
}

// The majorants of the factors grow without measure here: only the inverse gives a bound.
MatX banded(int size, Random& random) {
  const int n = 2 * size;
  MatX result = MatX::Zero(n, n);
  for (int r = 0; r < n; ++r) {
    for (int c = std::max(0, r - 2); c <= std::min(n - 1, r + 2); ++c) {
      result(r, c) = random.magnitude();
    }
  }
  return result;
}

MatX whole_numbers(int size, Random& random) {
  MatX result = MatX::Zero(size, size);
  for (int r = 0; r < size; ++r) {
    for (int i = 0; i < 3; ++i) {
      result(r, random.whole(0, size - 1)) = random.whole(-9, 9);
    }
    result(r, r) += random.whole(10, 20);
  }
  return result;
}

MatX long_chain(int size, Random& random) {
  const int n = 3 * size;
  MatX result = MatX::Identity(n, n);
  for (int i = 1; i < n; ++i) {
    result(i, i - 1) = -3.5 * random.magnitude();
  }
  return result;
}

// Of the largest unknown: half a unit in the last of 106 bits, and some.
const Rational kLeastShare = *read_decimal("2e-32");

class RefinedSolves : public ::testing::TestWithParam<Family> {
 protected:
  // Of each family; KINESTAT_SEEDS=4300 makes 10^5 solutions of them, in a minute or two.
  static int seed_count() {
    const char* const asked = std::getenv("KINESTAT_SEEDS");
    return asked != nullptr ? std::max(25, std::atoi(asked)) : 25;
  }

  static constexpr int kSteps = 3;

  // The systems of the family that are regular, with one right-hand side each.
  struct System {
    Elimination factors;
    std::vector<double> rhs;
    std::vector<Rational> x;
  };

  static void for_each_system(const std::function<void(const System&)>& test) {
    for (int seed = 0; seed < seed_count(); ++seed) {
      SCOPED_TRACE(fmt::format("{}, seed {}", GetParam().name, seed));
      Random random(static_cast<std::uint64_t>(seed));
      const MatX A = GetParam().make(random.whole(3, 30), random);
      const ExactElimination exact_factors(exact_matrix(sparse(A)), {});
      System system{.factors = Elimination(sparse(A), {}), .rhs = {}, .x = {}};
      if (system.factors.rank() < A.rows() || exact_factors.rank() < A.rows()) {
        continue;
      }
      for (Eigen::Index r = 0; r < A.rows(); ++r) {
        system.rhs.push_back(random.magnitude());
      }
      system.x =
          exact_factors.solve({}, std::vector<Rational>(system.rhs.begin(), system.rhs.end())).x;
      test(system);
    }
  }

  static std::vector<Rational> errors(const System& system, const RefinedSolve& solve) {
    const std::vector<DoubleDouble> x = solve.x();
    std::vector<Rational> result;
    for (std::size_t i = 0; i < x.size(); ++i) {
      result.emplace_back(abs(Rational(exact(x[i]) - system.x[i])));
    }
    return result;
  }

  // Counts the unknowns, and those whose bound is at most a hundred times their error.
  void expect_bounds(const System& system, const RefinedSolve& solve) {
    const std::optional<VecX> bound = solve.error_bound();
    ASSERT_TRUE(bound.has_value());
    const std::vector<Rational> off = errors(system, solve);
    for (std::size_t i = 0; i < off.size(); ++i) {
      const Rational limit((*bound)[static_cast<Eigen::Index>(i)]);
      EXPECT_LE(off[i], limit) << "unknown " << i;
      close_ += off[i].is_zero() || limit <= 100 * off[i] ? 1 : 0;
      ++count_;
    }
  }

  int close_ = 0;
  int count_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Family,
                         RefinedSolves,
                         ::testing::Values(Family{"sparse", random_with_diagonal},
                                           Family{"dense", random_dense},
                                           Family{"scales", random_scales},
                                           Family{"nearly_singular", nearly_singular},
                                           Family{"small_hilbert", small_hilbert},
                                           Family{"banded", banded},
                                           Family{"whole_numbers", whole_numbers},
                                           Family{"long_chain", long_chain}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(RefinedSolves, HaveBoundsThatCoverTheErrorAndAreClose) {
  for_each_system([&](const System& system) {
    RefinedSolve solve(system.factors, {}, system.rhs);
    for (int step = 0; step < kSteps; ++step) {
      SCOPED_TRACE(step);
      expect_bounds(system, solve);
      solve.refine();
    }
  });

  EXPECT_GT(count_, 300);
  EXPECT_GE(close_, 0.95 * count_);
}

// The flattest of these systems have a condition of 1e10: a step leaves at most 1e-4 of the error,
// down to what two doubles can hold.
TEST_P(RefinedSolves, LoseTheirErrorStepByStep) {
  for_each_system([&](const System& system) {
    Rational largest = 0;
    for (const Rational& x : system.x) {
      largest = std::max(largest, Rational(abs(x)));
    }
    RefinedSolve solve(system.factors, {}, system.rhs);
    Rational before = largest;
    for (int step = 0; step < kSteps; ++step) {
      const std::vector<Rational> off = errors(system, solve);
      const Rational worst = *std::ranges::max_element(off);
      EXPECT_LE(worst, std::max(Rational(before / 10000), Rational(largest * kLeastShare)));
      before = worst;
      solve.refine();
    }
  });
}

}  // namespace
}  // namespace kinestat
