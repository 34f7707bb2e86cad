#include "plot/sweep_curves.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

// Three heights and two speeds of one case; the last state has no ratio.
SweepTable small_sweep() {
  SweepTable sweep{.states = 6,
                   .varied = {"height [m]", "speed [rad/s]"},
                   .quantities = {"ratio", "d.wz [rad/s]"},
                   .rows = {}};
  add_sweep_rows(
      "3.0,1.0,\"a, b\",1.5,2.0,solved\n3.0,2.0,\"a, b\",1.5,4.0,solved\n"
      "4.0,1.0,\"a, b\",1.75,1.0,solved\n4.0,2.0,\"a, b\",1.75,2.0,solved\n"
      "5.0,1.0,\"a, b\",2.0,0.5,solved\n5.0,2.0,\"a, b\",,1.0,singular\n",
      sweep);
  return sweep;
}

TEST(SweepTable, HasTheRowsOfItsText) {
  const SweepTable sweep = small_sweep();

  ASSERT_EQ(sweep.rows.size(), 6U);
  EXPECT_EQ(sweep.rows[3].label, "a, b");
  EXPECT_EQ(sweep.rows[3].places, (std::vector<double>{4.0, 2.0}));
  EXPECT_EQ(sweep.rows[3].values[1], 2.0);
  EXPECT_FALSE(sweep.rows[5].values[0].has_value());
}

TEST(SweepTable, TellsApartLabelsThatBeginWithAQuote) {
  SweepTable sweep{.states = 2, .varied = {"h"}, .quantities = {"ratio"}, .rows = {}};
  add_sweep_rows("1.0,\"\"\"q\"\" x\",1.5,solved\n1.0,\"q\"\" x\",2.5,solved\n", sweep);

  ASSERT_EQ(sweep.rows.size(), 2U);
  EXPECT_EQ(sweep.rows[0].label, "\"q\" x");
  EXPECT_EQ(sweep.rows[1].label, "q\" x");
}

TEST(SweepFigure, RunsAlongTheParameterWithTheMostValues) {
  const Figure figure = sweep_figure(small_sweep(), "Sweep");

  ASSERT_EQ(figure.charts.size(), 2U);
  EXPECT_EQ(figure.charts[0].x.label, "height");
  EXPECT_EQ(figure.charts[0].x.unit, "m");
  EXPECT_EQ(figure.charts[1].y.label, "d.wz");
  EXPECT_EQ(figure.charts[1].y.unit, "rad/s");
}

TEST(SweepFigure, HasASeriesForEveryOtherChoice) {
  const std::vector<Series> series = sweep_figure(small_sweep(), "Sweep").charts[0].series;

  ASSERT_EQ(series.size(), 2U);
  EXPECT_EQ(series[1].name, "a, b, speed 2 rad/s");
  EXPECT_EQ(series[0].x, (std::vector<double>{3.0, 4.0, 5.0}));
  EXPECT_EQ(series[0].y, (std::vector<double>{1.5, 1.75, 2.0}));
}

TEST(SweepFigure, LeavesAGapWhereACaseHasNoValue) {
  const std::vector<Series> series = sweep_figure(small_sweep(), "Sweep").charts[0].series;

  EXPECT_TRUE(std::isnan(series[1].y.back()));
}

TEST(SweepFigure, HasNoChartWhereNothingIsVaried) {
  SweepTable sweep = small_sweep();
  sweep.rows.resize(1);

  EXPECT_TRUE(sweep_figure(sweep, "Sweep").charts.empty());
}

}  // namespace
}  // namespace kinestat
