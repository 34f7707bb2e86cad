#include "studies/sweep/picture/sweep_curves.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

// Three heights and two speeds of one case; the last state has no ratio.
SweepTable small_sweep() {
  return {.states = 6,
          .varied = {"height [m]", "speed [rad/s]"},
          .quantities = {"ratio", "d.wz [rad/s]"},
          .rows = {{.places = {3.0, 1.0}, .label = "a, b", .values = {1.5, 2.0}},
                   {.places = {3.0, 2.0}, .label = "a, b", .values = {1.5, 4.0}},
                   {.places = {4.0, 1.0}, .label = "a, b", .values = {1.75, 1.0}},
                   {.places = {4.0, 2.0}, .label = "a, b", .values = {1.75, 2.0}},
                   {.places = {5.0, 1.0}, .label = "a, b", .values = {2.0, 0.5}},
                   {.places = {5.0, 2.0}, .label = "a, b", .values = {std::nan(""), 1.0}}}};
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

TEST(SweepFigure, ShowsTheDrawsOfACaseAsPoints) {
  SweepTable sweep = small_sweep();
  sweep.is_sample = true;
  sweep.rows[0].places = {4.5, 1.5};
  sweep.rows[1].label = "other";
  const std::vector<Series> series = sweep_figure(sweep, "Sweep").charts[0].series;

  ASSERT_EQ(series.size(), 2U);
  EXPECT_EQ(series[0].name, "a, b");
  EXPECT_EQ(series[0].style, SeriesStyle::points);
  EXPECT_EQ(series[0].x, (std::vector<double>{4.0, 4.0, 4.5, 5.0, 5.0}));
  EXPECT_EQ(series[1].name, "other");
}

TEST(SweepFigure, LeavesAGapWhereACaseHasNoValue) {
  const std::vector<Series> series = sweep_figure(small_sweep(), "Sweep").charts[0].series;

  EXPECT_TRUE(std::isnan(series[1].y.back()));
}

TEST(SweepFigure, SaysWhatIsTheSameThroughoutAndDrawsItOnlyAlone) {
  SweepTable sweep = small_sweep();
  const std::size_t drawn = sweep_figure(sweep, "Sweep").charts.size();
  sweep.quantities.emplace_back("dead_points");
  for (SweepTableRow& row : sweep.rows) {
    row.values.push_back(2.0);
  }
  const Figure figure = sweep_figure(sweep, "Sweep");

  EXPECT_EQ(figure.charts.size(), drawn);
  EXPECT_TRUE(figure.description.ends_with(" dead_points is 2 throughout."));

  sweep.quantities = {"dead_points"};
  for (SweepTableRow& row : sweep.rows) {
    row.values = {2.0};
  }
  EXPECT_EQ(sweep_figure(sweep, "Sweep").charts.size(), 1U);
}

TEST(SweepLack, IsEmptyWhereThereAreCurves) {
  EXPECT_EQ(why_no_curves_of_sweep(small_sweep()), "");
}

TEST(SweepLack, IsAParameterWithTwoValues) {
  SweepTable sweep = small_sweep();
  sweep.rows.resize(1);

  EXPECT_TRUE(
      why_no_curves_of_sweep(sweep).starts_with("its sweep has no parameter with two values"));
  EXPECT_TRUE(sweep_figure(sweep, "Sweep").charts.empty());
}

TEST(SweepLack, SaysHowManyStatesAreTooMany) {
  SweepTable sweep = small_sweep();
  sweep.states = 20'001;
  sweep.rows.clear();

  EXPECT_TRUE(why_no_curves_of_sweep(sweep).starts_with(
      "its sweep has 20001 states, and curves are drawn of up to 20000"));
}

TEST(SweepLack, SaysThatNoStateIsAllowed) {
  SweepTable sweep = small_sweep();
  sweep.rows.clear();

  EXPECT_TRUE(why_no_curves_of_sweep(sweep).starts_with(
      "the conditions of its sweep leave no row of its 6 states"));
}

}  // namespace
}  // namespace kinestat
