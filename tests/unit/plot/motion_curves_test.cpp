#include "studies/motion/picture/motion_curves.hpp"

#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "core/motion_tolerance.hpp"
#include "files/load_file.hpp"
#include "mechanism/bind/bind.hpp"
#include "studies/motion/picture/motion_abscissa.hpp"
#include "studies/motion/task/find_motion.hpp"
#include "studies/motion/task/motion_choice.hpp"

namespace kinestat {
namespace {

// Of a file below the source folder, in two steps; empty where the report cannot be had.
std::optional<MotionTable> motion_with(const std::string& name,
                                       const std::vector<std::string>& report) {
  SourceFile source;
  Diagnostics found;
  const std::string path = std::string(KINESTAT_SOURCE_DIR) + "/" + name;
  std::optional<MechanismDescription> description = load_description(path, {}, source, found);
  MotionChoice choice;
  choice.steps = "2";
  choice.report = report;
  (void)apply(choice, *description, found);
  const auto mechanism = bind(*description, found);
  auto motion = find_motion(*description, *mechanism, found);
  return motion ? std::optional(std::move(motion->table)) : std::nullopt;
}

std::optional<std::size_t> index_of(const MotionTable& table, const std::string& name) {
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (table.columns[c].name() == name) {
      return c;
    }
  }
  return std::nullopt;
}

struct WholeReport {
  const char* file;
  std::vector<std::string> words;
};

class EveryColumn : public testing::TestWithParam<WholeReport> {};

TEST_P(EveryColumn, IsReportedAndDrawnAloneByItsName) {
  const std::string name = GetParam().file;
  const MotionTable whole = *motion_with(name, GetParam().words);
  ASSERT_GT(whole.columns.size(), 20U);

  for (std::size_t c = 0; c < whole.columns.size(); ++c) {
    const std::string column = whole.columns[c].name();
    const auto alone = motion_with(name, {column});
    ASSERT_TRUE(alone) << column;
    const auto at = index_of(*alone, column);
    ASSERT_TRUE(at) << column;
    for (std::size_t r = 0; r < whole.rows.size(); ++r) {
      const auto& value = alone->rows[r].values[*at];
      ASSERT_EQ(value.has_value(), whole.rows[r].values[c].has_value()) << column;
      if (value) {
        EXPECT_NEAR(*value, *whole.rows[r].values[c], 1e-12 * (1.0 + std::abs(*value))) << column;
      }
    }
    const Figure figure = motion_figure(*alone, "");
    ASSERT_LE(figure.charts.size(), 1U) << column;
    if (!figure.charts.empty()) {
      EXPECT_EQ(figure.charts[0].series.size(), 1U) << column;
      EXPECT_EQ(figure.charts[0].series[0].name, whole.columns[c].element);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    OfMotions,
    EveryColumn,
    testing::Values(
        WholeReport{.file = "mechanisms/planar/slider_crank.yaml",
                    .words = {"position",
                              "velocity",
                              "acceleration",
                              "action",
                              "power",
                              "ratio",
                              "transmission_angle",
                              "mechanical_advantage"}},
        WholeReport{
            .file = "tests/cli/motion_in_time/file.yaml",
            .words = {"position", "velocity", "acceleration", "action", "power", "dynamics"}}));

// A turn of the crank is 2 pi: a chart that went on to 8 rad would be empty for a fifth.
TEST(MotionCharts, EndWithTheMotion) {
  const auto motion = motion_with("mechanisms/planar/watt_six_bar.yaml", {"position"});
  ASSERT_TRUE(motion);

  const Figure figure = motion_figure(*motion, "");

  ASSERT_FALSE(figure.charts.empty());
  for (const Chart& chart : figure.charts) {
    EXPECT_NEAR(chart.x.low.value(), 0.0, 1e-12);
    EXPECT_NEAR(chart.x.high.value(), 2 * std::numbers::pi, 1e-12);
  }
}

// The crank and its joint turn as the drive, at its speed; the slider does not turn.
TEST(MotionCharts, LeaveOutTheDriveAndWhatIsAlwaysTheSame) {
  const auto motion =
      motion_with("mechanisms/planar/slider_crank.yaml", {"position", "velocity", "acceleration"});
  ASSERT_TRUE(motion);

  std::set<std::string> names;
  for (const Chart& chart : motion_figure(*motion, "").charts) {
    for (const Series& series : chart.series) {
      names.insert(series.name);
    }
  }

  EXPECT_EQ(names, (std::set<std::string>{"b.wz", "c.wz", "d.vx", "rod", "slider"}));
}

// What moves the slider needs no torque at its dead point.
TEST(MotionCharts, LeadNoLineThroughThePoleOfAQuotient) {
  const auto motion = motion_with("mechanisms/planar/slider_crank.yaml",
                                  {"ratio", "mechanical_advantage", "transmission_angle"});
  ASSERT_TRUE(motion);
  ASSERT_EQ(motion->events.size(), 1U);
  const auto behind = static_cast<std::size_t>(motion->events.front().step + 1);

  for (const Chart& chart : motion_figure(*motion, "").charts) {
    const bool is_quotient = !chart.y.label.starts_with("transmission angle");
    EXPECT_EQ(chart.series.at(0).breaks,
              is_quotient ? std::vector<std::size_t>{behind} : std::vector<std::size_t>())
        << chart.y.label;
  }
}

// To 90 deg and back, the row in which it is there in the middle.
MotionTable there_and_back() {
  MotionTable table;
  table.drives = {{.name = "motor", .freedom = "a.wz", .unit = "deg", .reached = 0.0}};
  table.columns = {{.element = "motor", .quantity = "drive", .unit = "deg"},
                   {.element = "", .quantity = "time", .unit = "s"},
                   {.element = "d.vx", .quantity = "velocity", .unit = "mm/s"}};
  const double speeds[] = {0.0, 7.0, 0.0, -3.0, 0.0};
  for (int step = 0; step < 5; ++step) {
    const double drive = 90.0 - 45.0 * std::abs(2 - step);
    table.rows.push_back(
        {.step = step, .values = {drive, 0.25 * step, speeds[step]}, .status = {}});
  }
  table.figures.resize(3);
  table.figures[2].greatest = {.value = 8.0, .drive = 67.5, .row = 1.5};
  table.events = {{.kind = "dead_point",
                   .element = "d.vx",
                   .step = 2,
                   .drive = {67.5},
                   .row = 2.5,
                   .places = {}}};
  return table;
}

// Where the speed jumps: just before and just behind.
std::vector<MotionPlace> sides_at(double row, double time, double before, double after) {
  return {{.row = row - kApproach, .values = {std::nullopt, time, before}},
          {.row = row + kApproach, .values = {std::nullopt, time, after}}};
}

TEST(MotionCharts, StandOverTimeWhereTheDriveComesBack) {
  const Figure figure = motion_figure(there_and_back(), "");

  ASSERT_EQ(figure.charts.size(), 2U);
  EXPECT_EQ(figure.charts[0].y.label, "position of motor");
  const Chart& speed = figure.charts[1];
  EXPECT_EQ(speed.x.label, "time");
  EXPECT_EQ(speed.series.at(0).x, (std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0}));
  ASSERT_EQ(speed.marks.size(), 1U);
  EXPECT_DOUBLE_EQ(speed.marks[0].x, 0.375);
  ASSERT_EQ(speed.series[0].between.size(), 1U);
  EXPECT_EQ(speed.series[0].between[0].before, 2U);
  EXPECT_DOUBLE_EQ(speed.series[0].between[0].x, 0.375);
  EXPECT_DOUBLE_EQ(speed.series[0].between[0].y, 8.0);
  ASSERT_EQ(speed.guides.size(), 1U);
  EXPECT_DOUBLE_EQ(speed.guides[0].x, 0.625);
  EXPECT_EQ(speed.guides[0].label, "dead point of d.vx at 0.625");
}

TEST(MotionCharts, LeadTheLineToEitherSideOfAJump) {
  MotionTable table = there_and_back();
  table.places = sides_at(2.5, 0.625, -1.0, -2.5);

  const Figure figure = motion_figure(table, "");

  const std::vector<PointBetween>& between = figure.charts.at(1).series.at(0).between;
  ASSERT_EQ(between.size(), 4U);  // the first is the peak
  EXPECT_DOUBLE_EQ(between[1].x, 0.625);
  EXPECT_EQ(between[1].y, -1.0);
  EXPECT_TRUE(std::isnan(between[2].y));
  EXPECT_DOUBLE_EQ(between[3].x, 0.625);
  EXPECT_EQ(between[3].y, -2.5);
  EXPECT_EQ(between[3].before, 3U);
}

TEST(MotionCharts, LeadTheLineToEitherSideOfARowOnAJump) {
  MotionTable table = there_and_back();
  table.places = sides_at(3.0, 0.75, -1.0, -2.5);
  table.rows[3].values[2] = std::nullopt;

  const Figure figure = motion_figure(table, "");

  const Series drawn = drawn_series(figure.charts.at(1).series.at(0));
  ASSERT_EQ(drawn.x.size(), 8U);  // the peak, and either side of row 3
  EXPECT_EQ(drawn.y[4], -1.0);
  EXPECT_TRUE(std::isnan(drawn.y[5]));
  EXPECT_EQ(drawn.y[6], -2.5);
  EXPECT_DOUBLE_EQ(drawn.x[4], 0.75);
  EXPECT_DOUBLE_EQ(drawn.x[6], 0.75);
}

TEST(MotionCharts, BreakTheLineBesideARowThatHasTheValueOfOneSide) {
  MotionTable table = there_and_back();
  table.places = sides_at(3.0, 0.75, -1.0, -3.0);
  const Series behind = drawn_series(motion_figure(table, "").charts.at(1).series.at(0));
  ASSERT_EQ(behind.x.size(), 8U);  // the peak, and the side before row 3
  EXPECT_EQ(behind.y[4], -1.0);
  EXPECT_TRUE(std::isnan(behind.y[5]));
  EXPECT_EQ(behind.y[6], -3.0);
  EXPECT_DOUBLE_EQ(behind.x[4], 0.75);

  table.places = sides_at(3.0, 0.75, -3.0, -1.0);
  const Series ahead = drawn_series(motion_figure(table, "").charts.at(1).series.at(0));
  ASSERT_EQ(ahead.x.size(), 8U);
  EXPECT_EQ(ahead.y[4], -3.0);
  EXPECT_TRUE(std::isnan(ahead.y[5]));
  EXPECT_EQ(ahead.y[6], -1.0);
  EXPECT_DOUBLE_EQ(ahead.x[6], 0.75);
}

TEST(MotionCharts, StandOverAnyColumn) {
  const MotionTable table = there_and_back();
  const Figure over_drive = motion_figure(table, "", find_abscissa(table, "motor"));
  const Figure over_speed = motion_figure(table, "", find_abscissa(table, "d.vx.velocity"));

  ASSERT_EQ(over_drive.charts.size(), 1U);
  EXPECT_EQ(over_drive.charts[0].x.label, "position of motor");
  EXPECT_DOUBLE_EQ(over_drive.charts[0].marks.at(0).x, 67.5);
  EXPECT_DOUBLE_EQ(over_drive.charts[0].guides.at(0).x, 67.5);
  ASSERT_EQ(over_speed.charts.size(), 1U);
  EXPECT_EQ(over_speed.charts[0].x.label, "velocity of d.vx");
  EXPECT_EQ(over_speed.charts[0].y.label, "position of motor");
  EXPECT_DOUBLE_EQ(over_speed.charts[0].guides.at(0).x, 0.0);
  EXPECT_FALSE(find_abscissa(table, "d.vx"));
}

TEST(MotionCharts, StandOverTheDriveThatRunsSteadilyInTime) {
  MotionTable table = there_and_back();
  table.rows.resize(3);

  EXPECT_EQ(usual_abscissa(table), 0U);
  table.rows[1].values[0] = 44.9;
  EXPECT_EQ(usual_abscissa(table), 1U);
}

TEST(MotionGuides, HaveOneLabelAPlaceInTheOrderOfNames) {
  MotionTable table;
  table.columns = {{.element = "motor", .quantity = "drive", .unit = "deg"},
                   {.element = "d", .quantity = "velocity", .unit = "rad/s"}};
  for (int step = 0; step < 3; ++step) {
    table.rows.push_back({.step = step, .values = {90.0 * step, 1.0 * step}, .status = {}});
  }
  const auto event = [](const char* kind, const char* element, double place) {
    return MotionEvent{.kind = kind, .element = element, .drive = {place}, .places = {}};
  };
  table.events = {event("dead_point", "G", 60.0),
                  event("dead_point", "D", 60.0 + 1e-9),
                  event("dead_point", "D", 120.0 - 1e-9),
                  event("dead_point", "G", 120.0),
                  event("limit", "motor", 120.0)};

  const std::vector<ChartGuide> guides = motion_figure(table, "").charts.at(0).guides;

  ASSERT_EQ(guides.size(), 2U);
  EXPECT_EQ(guides[0].label, "dead point of D, G at 60°");
  EXPECT_EQ(guides[1].label, "dead point of D, G, limit of motor at 120°");
}

TEST(MotionColumnNames, StandForAllThatBeginsWithThem) {
  const MotionTable table =
      *motion_with("mechanisms/planar/slider_crank.yaml", {"rod/linear", "Tin.velocity", "rod/y"});

  std::vector<std::string> names;
  for (const MotionColumn& column : table.columns) {
    names.push_back(column.name());
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"Tin/drive",
                                      "rod/at/y",
                                      "a.wz/velocity",
                                      "rod/linear/x",
                                      "rod/linear/y",
                                      "closure_error"}));
}

TEST(MotionColumnNames, LeavePlacesOfTracedPointsToThePathsUnlessNamed) {
  const char* const kFourBar = "mechanisms/planar/four_bar.yaml";
  const Figure positions = motion_figure(*motion_with(kFourBar, {"d.wz/position"}), "");
  const Figure figure = motion_figure(*motion_with(kFourBar, {"coupler.1/x"}), "");

  ASSERT_EQ(positions.charts.size(), 1U);
  EXPECT_EQ(positions.charts[0].y.label, "position of d.wz");
  ASSERT_EQ(figure.charts.size(), 1U);
  EXPECT_EQ(figure.charts[0].y.label, "at x of coupler.1");
}

}  // namespace
}  // namespace kinestat
