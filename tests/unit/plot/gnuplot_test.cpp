#include "draw/gnuplot.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "unit/plot/picture_text.hpp"

namespace kinestat {
namespace {

Figure figure_named(const std::string& name) {
  return {.name = "demo",
          .title = name,
          .description = "d",
          .charts = {{.x = {.label = "x", .unit = "mm"},
                      .y = {.label = "error", .unit = "", .scale = ScaleKind::logarithmic},
                      .series = {{.name = name,
                                  .x = {0.0, 1.5, 2.0},
                                  .y = {1e-16, std::numeric_limits<double>::quiet_NaN(), 1.0}}}}}};
}

TEST(Gnuplot, HasItsDataInside) {
  const std::string text = gnuplot_text(figure_named("s"));

  EXPECT_TRUE(text.starts_with(gnuplot_signature()));
  EXPECT_TRUE(has(text, "$data_1_1 << END\n0.0 1e-16\n1.5 NaN\n2.0 1.0\nEND\n"));
  EXPECT_TRUE(has(text, "set logscale y"));
  EXPECT_TRUE(has(text, "set xlabel 'x [mm]'"));
}

// In single quotes only the quote has a meaning; a line end would begin a new command.
TEST(Gnuplot, LetsNoNameBecomeACommand) {
  const std::string text = gnuplot_text(figure_named("x'\nsystem \"id\"\n'"));

  EXPECT_FALSE(has(text, "\nsystem"));
  EXPECT_TRUE(has(text, "'x'' system \"id\" '''"));
}

TEST(Gnuplot, TellsTitleAndDescriptionInItsFirstLines) {
  Figure figure = figure_named("Watt's\nlinkage");
  figure.description = "its\nerror";

  EXPECT_TRUE(gnuplot_text(figure).starts_with(std::string(gnuplot_signature()) +
                                               "# Watt's linkage\n# its error\nset encoding"));
}

TEST(Gnuplot, LetsNoNameOfARowEndItsString) {
  const BarMap map = {.name = "demo",
                      .title = "t",
                      .mechanism = "m",
                      .description = "d",
                      .columns = {"M\"1\\"},
                      .blocks = {{.title = "b", .rows = {{.name = "r\nEND", .values = {2.0}}}}},
                      .remarks = {}};

  EXPECT_TRUE(has(gnuplot_text(map), "\"\" \"M_1_\"\n\"r_END\" 2.0\nEND\n"));
}

}  // namespace
}  // namespace kinestat
