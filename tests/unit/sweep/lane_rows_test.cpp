#include "studies/sweep/task/lane_rows.hpp"

#include <array>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "math/tapes/lane_recorder.hpp"

namespace kinestat {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Two inputs, of which the second gets these values in the lanes, and whether they are clear beside
// the first.
std::vector<bool> are_clear(std::size_t lanes, double first, const std::vector<double>& second) {
  LaneRecorder recorder;
  const std::array inputs = {recorder.input(1.0), recorder.input(1.0)};
  const LaneTape tape = recorder.make_tape(inputs);
  LaneTape::Workspace workspace = tape.make_workspace(lanes);
  std::vector<bool> clear;
  for (std::size_t from = 0; from < second.size(); from += lanes) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      tape.set_input(workspace, 0, lane, first);
      tape.set_input(workspace, 1, lane, second.at(from + lane));
    }
    tape.play(workspace);
    const std::array<TapedColumn, 2> columns = {
        {{.column = 0, .cell = tape.output_cell(0)}, {.column = 1, .cell = tape.output_cell(1)}}};
    LaneMagnitudes found;
    found.add(workspace, columns);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      clear.push_back(found.are_clear(lane));
    }
  }
  return clear;
}

TEST(LaneMagnitudes, AreClearUnlessOneMayBeRoundingOrIsTooLarge) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> second = {0.0, -0.0, -3e-12, 3e-13, -nan, -kInfinity, 2e150, 1e11};
  const std::vector<bool> expected = {true, true, true, false, false, false, false, true};
  EXPECT_EQ(are_clear(kLanes, -2.0, second), expected);
  EXPECT_EQ(are_clear(1, -2.0, second), expected);
}

TEST(LaneMagnitudes, AreClearWhereAllAreZero) {
  EXPECT_EQ(are_clear(1, 0.0, {0.0, 5e-324}), (std::vector<bool>{true, true}));
}

TEST(LaneMagnitudes, CompareWithWhatStandsBesideThem) {
  LaneRecorder recorder;
  const std::array inputs = {recorder.input(1.0)};
  const LaneTape tape = recorder.make_tape(inputs);
  LaneTape::Workspace workspace = tape.make_workspace(1);
  tape.set_input(workspace, 0, 0, 1e-3);
  const std::array cells = {tape.output_cell(0)};
  LaneMagnitudes alone;
  alone.add(workspace, cells);
  EXPECT_TRUE(alone.are_clear(0));
  LaneMagnitudes beside(1e10);
  beside.add(workspace, cells);
  EXPECT_FALSE(beside.are_clear(0));
}

}  // namespace

}  // namespace kinestat
