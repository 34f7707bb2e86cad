#include "studies/simulation/picture/simulation_curves.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "files/load_file.hpp"
#include "studies/simulation/report/simulation_table.hpp"
#include "studies/simulation/task/find_simulation.hpp"

namespace kinestat {
namespace {

// The block leaves the belt where friction bears mu_static m g, and slides with mu m g then: both
// are sides of jumps that stand between the rows.
TEST(SimulationCharts, LeadTheLineToEitherSideOfSticking) {
  constexpr double kHolds = 0.4 * 1.5 * 9.81;
  constexpr double kSlides = 0.25 * 1.5 * 9.81;
  SourceFile source;
  Diagnostics found;
  const std::string path = std::string(KINESTAT_SOURCE_DIR) + "/mechanisms/planar/stick_slip.yaml";
  const auto description = load_description(path, {}, source, found);
  ASSERT_TRUE(description);
  const auto simulation = find_simulation(*description, found);
  ASSERT_TRUE(simulation);
  const MotionTable table = simulation_table({.file = path,
                                              .description = *description,
                                              .mechanism = simulation->mechanism,
                                              .plan = simulation->plan,
                                              .solution = simulation->solution,
                                              .found = nullptr});

  int jumps = 0;
  for (const Chart& chart : simulation_figure(table, "").charts) {
    if (chart.y.label != "action of drive") {
      continue;
    }
    const std::vector<PointBetween>& between = chart.series.at(0).between;
    for (std::size_t i = 1; i + 1 < between.size(); ++i) {
      const bool slips = std::isnan(between[i].y) && between[i - 1].y > kSlides;
      if (slips) {
        EXPECT_NEAR(between[i - 1].y, kHolds, 1e-6);
        EXPECT_NEAR(between[i + 1].y, kSlides, 1e-6);
        ++jumps;
      }
    }
  }
  EXPECT_EQ(jumps, 5);
}

}  // namespace
}  // namespace kinestat
