#include "studies/benchmark/solve_problem.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "library_mechanism.hpp"
#include "math/dense/dense_methods.hpp"

namespace kinestat {
namespace {

ProblemAnswer problem_of(const Mechanism& mechanism, ProblemSide side, const Extreme& extreme) {
  return make_problem(mechanism, mechanism.cases.front(), side, extreme);
}

// The largest difference between the dense form and the exact solution of the sparse one.
double difference(const SolveProblem& problem) {
  const std::vector<DoubleDouble> x =
      solve_by(DenseMethod::double_lu, problem.dense, problem.dense_right);
  double largest = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double unit = problem.units[static_cast<Eigen::Index>(i)];
    largest = std::max(largest, std::abs(x[i].high / unit - to_double(problem.exact[i])));
  }
  return largest;
}

class BothForms : public testing::TestWithParam<std::string> {};

TEST_P(BothForms, OfMotionsHaveOneSolution) {
  const Mechanism mechanism = library_mechanism(GetParam());

  const ProblemAnswer drawn = problem_of(mechanism, ProblemSide::motion, kExtremes[0]);
  const ProblemAnswer moved = problem_of(mechanism, ProblemSide::motion, {"", 1.0, 10.0});

  EXPECT_LT(difference(drawn.problem.value()), 1e-9);
  EXPECT_LT(difference(moved.problem.value()), 1e-9);
  EXPECT_EQ(drawn.problem->exact, moved.problem->exact);
}

TEST_P(BothForms, OfActionsHaveOneSolution) {
  const Mechanism mechanism = library_mechanism(GetParam());

  const ProblemAnswer drawn = problem_of(mechanism, ProblemSide::action, kExtremes[0]);
  const ProblemAnswer moved = problem_of(mechanism, ProblemSide::action, {"", 1.0, 10.0});

  EXPECT_LT(difference(drawn.problem.value()), 1e-9);
  EXPECT_LT(difference(moved.problem.value()), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Library,
                         BothForms,
                         testing::Values("planar/four_bar.yaml", "transmissions/ravigneaux.yaml"),
                         [](const auto& one) { return one.index == 0 ? "FourBar" : "Ravigneaux"; });

// Cazangi 2008, section 5.4: A_NS of the Ravigneaux train is 36 x 36.
TEST(SolveProblem, OfTheRavigneauxTrainHasTheTextbooksSize) {
  const Mechanism mechanism = library_mechanism("transmissions/ravigneaux.yaml");

  const ProblemAnswer answer = problem_of(mechanism, ProblemSide::action, kExtremes[0]);

  EXPECT_EQ(answer.problem.value().dense.rows(), 36);
  EXPECT_EQ(answer.problem.value().dense.cols(), 36);
}

// Lengths scale moments and velocities, which the units of the node system take out again.
TEST(SolveProblem, HasTheSameSolutionInOtherUnits) {
  const Mechanism mechanism = library_mechanism("planar/four_bar.yaml");

  const ProblemAnswer drawn = problem_of(mechanism, ProblemSide::motion, kExtremes[0]);
  const ProblemAnswer large = problem_of(mechanism, ProblemSide::motion, {"", 1024.0, 0.0});

  EXPECT_EQ(drawn.problem.value().exact, large.problem.value().exact);
}

class AtEveryExtreme : public testing::TestWithParam<std::string> {};

// Slides, couples and forces among them.
TEST_P(AtEveryExtreme, ThereIsAProblem) {
  const Mechanism mechanism = library_mechanism(GetParam());

  for (const Extreme& extreme : kExtremes) {
    EXPECT_EQ(problem_of(mechanism, ProblemSide::motion, extreme).reason, NoProblem::none)
        << extreme.name;
    EXPECT_EQ(problem_of(mechanism, ProblemSide::action, extreme).reason, NoProblem::none)
        << extreme.name;
  }
}

constexpr std::array<const char*, 3> kNames = {"SliderCrank", "QuickReturn", "Rssr"};

INSTANTIATE_TEST_SUITE_P(Library,
                         AtEveryExtreme,
                         testing::Values("planar/slider_crank.yaml",
                                         "planar/quick_return.yaml",
                                         "spatial/rssr.yaml"),
                         [](const auto& one) { return kNames[one.index]; });

// Crank and coupler that are both held hold each other.
TEST(SolveProblem, LeavesOutEquationsThatFollowFromOthers) {
  const Mechanism mechanism = library_mechanism("planar/four_bar.yaml");
  Case which = mechanism.cases.front();
  which.motions.resize(2);
  for (int f = 0; f < 2; ++f) {
    which.motions[static_cast<std::size_t>(f)].index = f;
    which.motions[static_cast<std::size_t>(f)].value = 0.0;
  }

  const ProblemAnswer answer = make_problem(mechanism, which, ProblemSide::motion, kExtremes[0]);

  ASSERT_TRUE(answer.problem.has_value());
  EXPECT_EQ(answer.problem->secondary.size(), 2U);
  EXPECT_EQ(answer.problem->matrix.rows, 11);  // three twists in the plane and two rates
  EXPECT_EQ(answer.problem->dense.rows(), 2);
  EXPECT_LT(difference(*answer.problem), 1e-12);
}

// First gear of the 4HP14: its meshes are redundant, and what places they have as doubles makes
// them contradict each other by a rounding.
TEST(SolveProblem, IsThereForRedundantTrains) {
  const Mechanism mechanism = library_mechanism("transmissions/ravigneaux_4hp14.yaml");
  Case which;
  for (int f = 0; f < mechanism.topology.freedom_count(); ++f) {
    const std::string name = mechanism.topology.freedom_name(f);
    if (name == "I.wz" || name == "C1.wz" || name == "B2.wz") {
      which.motions.emplace_back();
      which.motions.back().index = f;
      which.motions.back().value = name == "I.wz" ? 100.0 : 0.0;
    }
  }

  for (const Extreme& extreme : kExtremes) {
    EXPECT_EQ(make_problem(mechanism, which, ProblemSide::motion, extreme).reason, NoProblem::none)
        << extreme.name;
  }
}

TEST(SolveProblem, IsNoneWhereNothingIsKnown) {
  const Mechanism mechanism = library_mechanism("planar/four_bar.yaml");
  Case unknown;

  const ProblemAnswer answer = make_problem(mechanism, unknown, ProblemSide::motion, kExtremes[0]);

  EXPECT_EQ(answer.reason, NoProblem::not_asked);
  EXPECT_FALSE(answer.problem);
}

TEST(SolveProblem, IsNoneWhereTooMuchIsKnown) {
  const Mechanism mechanism = library_mechanism("planar/four_bar.yaml");
  Case which = mechanism.cases.front();
  for (int f = 0; f < 2; ++f) {
    which.motions.resize(2);
    which.motions[static_cast<std::size_t>(f)].index = f;
  }

  const ProblemAnswer answer = make_problem(mechanism, which, ProblemSide::motion, kExtremes[0]);

  EXPECT_EQ(answer.reason, NoProblem::dependent);
}

}  // namespace
}  // namespace kinestat
