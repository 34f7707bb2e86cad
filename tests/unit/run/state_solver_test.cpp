#include "studies/sweep/task/state_solver.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "core/tolerance.hpp"
#include "unit/run/swept_file.hpp"
#include "unit/run/swept_rows.hpp"

namespace kinestat {
namespace {

std::string ravigneaux() {
  std::ifstream file(KINESTAT_MECHANISMS "/transmissions/ravigneaux.yaml");
  std::ostringstream text;
  text << file.rdbuf();
  const std::string all = text.str();
  return all.substr(0, all.find("\npublished:"));
}

TEST(StateSolver, GivesTheSameBitsForAnyLanesAndAnyBeginning) {
  SweptFile file(ravigneaux(),
                 "{vary: {N1: {from: 15, to: 20, step: 1}, N2: {from: 40, to: 45, step: 1}, "
                 "N5: {from: 12, to: 18, step: 1}, T_in: [50 N*m, 100 N*m]}}");
  ASSERT_TRUE(file.task().tapes.has_value());

  const std::vector<Row> lanes = rows_of(file.task(), kLanes);
  const std::vector<Row> alone = rows_of(file.task(), 1);
  const std::vector<Row> later = rows_of(file.task(), kLanes, 3);

  expect_same_bits(lanes, alone);
  const auto cases = static_cast<std::ptrdiff_t>(file.task().cases.size());
  expect_same_bits({lanes.begin() + 3 * cases, lanes.end()}, later);
}

TEST(StateSolver, FindsWhatAnalysesFindInTheRavigneauxTrain) {
  SweptFile file(ravigneaux(),
                 "{vary: {N1: {from: 15, to: 34, step: 1}, N2: [31, 41, 63], "
                 "N5: {from: 12, to: 31, step: 4}}, cases: [M1, MR]}");
  ASSERT_TRUE(file.task().tapes.has_value());
  EXPECT_FALSE(file.task().tapes->needs_geometry);

  const std::vector<Row> taped = rows_of(file.task(), kLanes);

  // With N1 + N5 = N2 + 8 the long planet meets the short one on its own axis: a dead point.
  EXPECT_TRUE(std::ranges::any_of(taped, [](const Row& row) { return row.status == "singular"; }));
  EXPECT_TRUE(std::ranges::any_of(taped, [](const Row& row) { return row.status == "solved"; }));
  expect_near(taped, analysed_rows(file.task()));
}

TEST(StateSolver, FindsWhatAnalysesFindWhereParametersFollowFromOthers) {
  SweptFile file(kTrain,
                 "{vary: {S: {from: 15, to: 30, step: 1}, P: [20, 24, 31], "
                 "torque: [0 N*m, 3 N*m]}}");
  ASSERT_TRUE(file.task().tapes.has_value());

  expect_near(rows_of(file.task(), kLanes), analysed_rows(file.task()));
}

// ω_rocker/ω_crank = x/(x - 8), where the coupler's line meets the frame's at x = (6 - 6 y)/(3 -
// y).
TEST(StateSolver, AnalysesTheStatesNearADeadPointAsAWhole) {
  SweptFile file(kFourBar,
                 "{vary: {y: [0.25, 0.5, 0.9, 0.99999, 1, 1.00001, 1.1, 1.5, 2, 2.5]}, "
                 "report: [ratio, crank, b.Rx]}");
  const std::vector<double> heights = {0.25, 0.5, 0.9, 0.99999, 1, 1.00001, 1.1, 1.5, 2, 2.5};
  SweepTask& task = file.task();
  ASSERT_TRUE(task.tapes.has_value());

  const std::vector<Row> rows = rows_of(task, kLanes);

  ASSERT_EQ(rows.size(), heights.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    SCOPED_TRACE(heights[i]);
    EXPECT_EQ(rows[i].status, heights[i] == 1.0 ? "singular" : "solved");
    if (heights[i] != 1.0) {
      const double x = (6 - 6 * heights[i]) / (3 - heights[i]);
      EXPECT_NEAR(rows[i].values[0], x / (x - 8), 1e-12);
    }
  }
  expect_near(rows, analysed_rows(task));

  // The tape itself answers for those that are well off it, and for no others.
  TapeSolver taped(task, *task.tapes, kLanes);
  std::vector<SweepRow> filled(kLanes, {.values = std::vector<double>(3)});
  StateWalk walk(task.plan, 0, task.plan.state_count());
  for (const double height : heights) {
    SCOPED_TRACE(height);
    ASSERT_TRUE(walk.next());
    taped.load(walk, walk.state() % kLanes);
    taped.play();
    taped.fill(kLanes, filled);
    EXPECT_EQ(taped.has_answer(walk.state() % kLanes), std::abs(height - 1.0) > 1e-3);
  }
}

TEST(StateSolver, TakesWhatAFormulaCannotSayFromEachState) {
  const std::string text = kFourBar;
  const std::size_t at = text.find("at: [2, y]");
  SweptFile file(text.substr(0, at) + "at: [2, sqrt(y)*sqrt(y)]" + text.substr(at + 10),
                 "{vary: {y: {from: 1.5, to: 4, step: 0.125}}}");
  ASSERT_TRUE(file.task().tapes.has_value());
  EXPECT_TRUE(file.task().tapes->needs_geometry);

  expect_same_bits(rows_of(file.task(), kLanes), rows_of(file.task(), 1));
  expect_near(rows_of(file.task(), kLanes), analysed_rows(file.task()));
}

TEST(StateSolver, WorksOutNoMoreThanIsAskedFor) {
  const std::string vary = "{vary: {N1: {from: 15, to: 20, step: 1}}, cases: [M1]";
  SweptFile everything(ravigneaux(), vary + "}");
  SweptFile two(ravigneaux(), vary + ", report: [out, B2]}");

  EXPECT_LT(2 * two.task().tapes->tape.operation_count(),
            everything.task().tapes->tape.operation_count() + 60);
  const std::vector<Row> all = rows_of(everything.task(), kLanes);
  const std::vector<Row> some = rows_of(two.task(), kLanes);
  for (std::size_t q = 0; q < 2; ++q) {
    const std::string& name = two.task().columns[q].name;
    const auto column = std::ranges::find(everything.task().columns, name, &SweepColumn::name);
    ASSERT_NE(column, everything.task().columns.end());
    for (std::size_t r = 0; r < all.size(); ++r) {
      EXPECT_EQ(
          some[r].values[q],
          all[r].values[static_cast<std::size_t>(column - everything.task().columns.begin())]);
    }
  }
}

}  // namespace
}  // namespace kinestat
