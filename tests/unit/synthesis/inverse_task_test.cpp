// Tasks made from linkages that are known: their dyads must be among the answers.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "known_linkage.hpp"
#include "near_dyad.hpp"
#include "studies/synthesis/dyads/burmester.hpp"

namespace kinestat {
namespace {

struct TaskForm {
  std::string name;
  std::vector<int> orders;
};

constexpr int kTasksOfAForm = 180;

class InverseTasks : public testing::TestWithParam<TaskForm> {};

struct Tally {
  int tasks = 0;
  int with_digits = 0;
};

void check_known(const Dyad& known, const BurmesterSolution& solution, Tally& tally) {
  ++tally.tasks;
  const Dyad found = nearest_dyad(solution.dyads, known);
  const bool has_digits = found.digits > 10.0;
  tally.with_digits += has_digits ? 1 : 0;
  EXPECT_LT(distance(found, known), has_digits ? 1e-9 : std::pow(10.0, 2.0 - found.digits))
      << "digits " << found.digits << " reciprocal condition number "
      << solution.reciprocal_condition << " kind " << static_cast<int>(known.kind);
}

TEST_P(InverseTasks, HaveTheKnownDyadsAmongTheirAnswers) {
  using enum DyadKind;
  const std::vector<std::pair<DyadKind, DyadKind>> kinds = {{crank, crank},
                                                            {crank, crank},
                                                            {crank, slider},
                                                            {crank, inverted_slider},
                                                            {slider, inverted_slider}};
  Random random(1983);
  Tally tally;
  for (int seed = 0; tally.tasks < 2 * kTasksOfAForm; ++seed) {
    SCOPED_TRACE(seed);
    const auto [one, other] = kinds[static_cast<std::size_t>(seed) % kinds.size()];
    const KnownLinkage linkage = random_linkage(random, one, other);
    const auto positions = random_positions(random, linkage, GetParam().orders);
    if (positions.empty()) {
      continue;
    }
    const BurmesterSolution solution = solve_burmester(positions);
    ASSERT_EQ(solution.status, BurmesterStatus::solved);
    check_known(linkage.one, solution, tally);
    check_known(linkage.other, solution, tally);
    for (const Dyad& dyad : solution.dyads) {
      EXPECT_LT(dyad.residual, std::max(1e-11, std::pow(10.0, -dyad.digits)));
    }
  }
  // Random tasks are flat now and then; almost all must leave the ten digits that are asked for.
  EXPECT_GT(tally.with_digits, 9 * tally.tasks / 10);
}

INSTANTIATE_TEST_SUITE_P(FivePositions,
                         InverseTasks,
                         testing::Values(TaskForm{"PPPPP", {5}},
                                         TaskForm{"PPPPandP", {4, 1}},
                                         TaskForm{"PPPandPP", {3, 2}},
                                         TaskForm{"PPPandPandP", {3, 1, 1}},
                                         TaskForm{"PPandPPandP", {2, 2, 1}},
                                         TaskForm{"PPandPandPandP", {2, 1, 1, 1}},
                                         TaskForm{"Finite", {1, 1, 1, 1, 1}}),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace kinestat
