#include "draw/chart.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/contract.hpp"
#include "unit/plot/picture_text.hpp"

namespace kinestat {
namespace {

Figure figure_of(Chart chart) {
  return {.name = "demo", .title = "t", .description = "d", .charts = {std::move(chart)}};
}

Chart line_chart() {
  return {.x = {.label = "angle", .unit = "deg"},
          .y = {.label = "speed", .unit = "rad/s"},
          .series = {{.name = "rocker", .x = {0.0, 90.0, 180.0}, .y = {1.0, 3.0, 2.0}}}};
}

TEST(Chart, NamesItsAxesWithUnits) {
  const Picture picture = draw_figure(figure_of(line_chart()));

  EXPECT_TRUE(has(picture, ">angle [deg]<"));
  EXPECT_TRUE(has(picture, ">speed [rad/s]<"));
}

TEST(Chart, PutsPowersOfTenIntoTheUnit) {
  EXPECT_EQ(axis_title({.label = "force", .unit = "N"}, 3), "force [10³ N]");
  EXPECT_EQ(axis_title({.label = "ratio", .unit = ""}, 0), "ratio");
  EXPECT_EQ(axis_title({.label = "ratio", .unit = ""}, 6), "ratio [10⁶]");
}

TEST(Chart, HasALegendOnlyForSeveralSeries) {
  Chart chart = line_chart();
  EXPECT_EQ(count_of(draw_figure(figure_of(chart)), ">rocker<"), 1U);  // the title of its group

  chart.series.push_back({.name = "coupler", .x = {0.0, 180.0}, .y = {1.0, 2.0}});
  EXPECT_EQ(count_of(draw_figure(figure_of(chart)), ">rocker<"), 2U);
}

// The first ink is blue, the third green.
TEST(Chart, DrawsASeriesByItsLook) {
  Chart chart = line_chart();
  EXPECT_TRUE(has(draw_figure(figure_of(chart)), "ks-s-blue"));

  chart.series.front().look = 2;
  const Picture picture = draw_figure(figure_of(chart));

  EXPECT_TRUE(has(picture, "ks-s-green"));
  EXPECT_FALSE(has(picture, "ks-s-blue"));
}

// A line through one point has no length.
TEST(Chart, MarksAPointBetweenGaps) {
  Chart chart = line_chart();
  chart.series.front().y = {kGap, 3.0, kGap};

  EXPECT_TRUE(has(draw_figure(figure_of(chart)), "<circle"));
}

TEST(Chart, LeavesGapsWhereThereIsNoValue) {
  Chart chart = line_chart();
  chart.series.front() = {
      .name = "s", .x = {0.0, 60.0, 90.0, 120.0, 180.0}, .y = {1.0, 2.0, kGap, 2.0, 1.0}};

  const Picture picture = draw_figure(figure_of(chart));

  const std::size_t begin = picture.elements.find(" d=\"M", picture.elements.find("data-series"));
  const std::string data =
      picture.elements.substr(begin + 4, picture.elements.find('"', begin + 4) - begin - 4);
  EXPECT_EQ(std::count(data.begin(), data.end(), 'M'), 2);
  EXPECT_EQ(picture.elements.find("nan"), std::string::npos);
}

TEST(Chart, LeadsNoLineThroughAPoleAndLinesThroughPointsBetween) {
  Series series = {
      .name = "s", .x = {0.0, 60.0, 120.0, 180.0}, .y = {1.0, 9.0, -9.0, -1.0}, .breaks = {2}};
  series.between = {{.before = 3, .x = 140.0, .y = -0.7}, {.before = 3, .x = 150.0, .y = -0.5}};

  const Series drawn = drawn_series(series);

  ASSERT_EQ(drawn.x.size(), 7U);
  EXPECT_TRUE(std::isnan(drawn.x[2]) && std::isnan(drawn.y[2]));
  EXPECT_EQ(drawn.x[4], 140.0);
  EXPECT_EQ(drawn.x[5], 150.0);
  EXPECT_EQ(drawn.y[5], -0.5);
}

TEST(Chart, TellsMarksInTheUnitOfItsAxis) {
  Chart chart = line_chart();
  chart.series.front().y = {0.0, 41190.0, -80880.0};
  chart.marks = {{.x = 90.0, .y = 41190.0, .label = "max", .tells_value = true}};

  const Picture picture = draw_figure(figure_of(chart));

  EXPECT_TRUE(has(picture, ">speed [10³ rad/s]<"));
  EXPECT_TRUE(has(picture, ">max 41.19<"));
}

TEST(Chart, SaysWhereThereAreNoData) {
  Chart chart = line_chart();
  chart.series.front().y = {kGap, kGap, kGap};

  EXPECT_TRUE(has(draw_figure(figure_of(chart)), ">no data<"));
}

TEST(Chart, StandsAConstantValueInTheMiddle) {
  Chart chart = line_chart();
  chart.series.front().y = {2.0, 2.0, 2.0};

  EXPECT_FALSE(has(draw_figure(figure_of(chart)), ">no data<"));
}

TEST(Chart, WritesLabelsOfMarksAndGuides) {
  Chart chart = line_chart();
  chart.marks = {{.x = 90.0, .y = 3.0, .label = "max 3"}};
  chart.guides = {{.x = 45.0, .label = "dead point"}};

  const Picture picture = draw_figure(figure_of(chart));

  EXPECT_TRUE(has(picture, ">max 3<"));
  EXPECT_TRUE(has(picture, ">dead point<"));
}

TEST(Chart, TellsTheEventsOfCrowdedGuidesByNumbers) {
  Chart chart = line_chart();
  chart.width = 200.0;
  const std::string words = "a dead point with a long name at ";
  chart.guides = {{.x = 60.0, .label = words + "60"}, {.x = 110.0, .label = words + "110"}};

  const Picture picture = draw_figure(figure_of(chart));

  EXPECT_TRUE(has(picture, ">1 " + words + "60<"));
  EXPECT_TRUE(has(picture, ">2 " + words + "110<"));
  EXPECT_TRUE(has(picture, ">1<"));
  EXPECT_TRUE(has(picture, ">2<"));
}

TEST(Chart, NamesGuidesUnderThePointerAloneWhereWordsStandElsewhere) {
  Chart chart = line_chart();
  chart.guides = {{.x = 45.0, .label = "dead point", .is_named = false}};

  const Picture picture = draw_figure(figure_of(chart));

  EXPECT_TRUE(has(picture, "<title>dead point</title>"));
  EXPECT_FALSE(has(picture, ">dead point</text>"));
}

// A motion of many turns has thousands of dead points: all have a line, and as many a label as can
// be read.
TEST(Chart, LabelsTheFirstGuidesAlone) {
  Chart chart = line_chart();
  for (int i = 0; i < 3000; ++i) {
    chart.guides.push_back({.x = 0.06 * i, .label = "dead point"});
  }

  const Picture picture = draw_figure(figure_of(chart));

  EXPECT_LT(picture.view.height(), 2000.0);
  EXPECT_GE(count_of(picture, ">dead point<"), 1U);
  EXPECT_LE(count_of(picture, ">dead point<"), 100U);
  EXPECT_GE(count_of(picture, "M"), 3000U);  // where a line begins
}

TEST(Chart, LeavesOutGuidesBesideTheAxis) {
  Chart chart = line_chart();
  chart.guides = {{.x = 500.0, .label = "far off"}};

  EXPECT_FALSE(has(draw_figure(figure_of(chart)), "far off"));
}

TEST(Chart, DrawsAThousandPointsOnAPixelAsFew) {
  Chart chart = line_chart();
  Series& series = chart.series.front();
  series.x.clear();
  series.y.clear();
  for (int i = 0; i <= 100000; ++i) {
    series.x.push_back(i / 1000.0);
    series.y.push_back(1.0);
  }

  EXPECT_LT(draw_figure(figure_of(chart)).elements.size(), 60000U);
}

TEST(Chart, GivesAStraightPathAFrame) {
  Chart chart = line_chart();
  chart.has_equal_scales = true;
  chart.series.front() = {.name = "p", .x = {0.0, 10.0}, .y = {1.0, 1.0}};

  const Picture picture = draw_figure(figure_of(chart));

  EXPECT_GT(picture.view.height(), 60.0);
}

// A body that stays where it is, and a force that is always zero.
TEST(Chart, GivesAPathOfOnePointAFrame) {
  for (const double place : {0.0, 3.0, -1e-4}) {
    Chart chart = line_chart();
    chart.has_equal_scales = true;
    chart.series.front() = {.name = "p", .x = {place, place}, .y = {place, place}};

    const Picture picture = draw_figure(figure_of(chart));

    EXPECT_GT(picture.view.height(), 60.0);
    EXPECT_LT(picture.view.height(), 800.0);
    EXPECT_FALSE(has(picture, ">no data<"));
  }
}

TEST(Chart, WantsAsManyXAsY) {
  Chart chart = line_chart();
  chart.series.front().x.pop_back();

  EXPECT_THROW(draw_figure(figure_of(chart)), ContractViolation);
}

TEST(Chart, IsTheSameEveryTime) {
  EXPECT_EQ(svg_file(draw_figure(figure_of(line_chart()))),
            svg_file(draw_figure(figure_of(line_chart()))));
}

}  // namespace
}  // namespace kinestat
