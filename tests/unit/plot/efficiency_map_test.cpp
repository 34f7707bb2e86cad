#include "studies/duty/efficiency_map.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cases/solve_cases.hpp"
#include "core/source.hpp"
#include "files/load_file.hpp"
#include "picture_text.hpp"
#include "studies/duty/picture/efficiency_picture.hpp"
#include "studies/duty/task/find_duty.hpp"

namespace kinestat {
namespace {

// A pinion of 20 teeth drives a wheel of 50; teeth lose 2 %, the bearing of the pinion rubs with
// `drag`.
std::string pair_text(const std::string& drag, const std::string& points) {
  return "kinestat: 1\nspace: planar\nunits: {length: mm}\nground: frame\n"
         "bodies: [pinion, wheel]\ncouplings:\n"
         "  a: {type: revolute, bodies: [frame, pinion]" +
         drag +
         "}\n"
         "  b: {type: revolute, bodies: [frame, wheel]}\n"
         "gears:\n  module: 2 mm\n"
         "  members: {p: {body: pinion, teeth: 20}, w: {body: wheel, teeth: 50}}\n"
         "  meshes: {m: {members: [p, w]}}\n"
         "actuators: {in: {coupling: a}, out: {coupling: b}}\n"
         "losses: {gear_external: 0.02}\n"
         "cases:\n"
         "  run: {motion: {in: 100 rad/s}, action: {in: 10 N*m}, input: in, output: out}\n"
         "duty: {points: [" +
         points + "]}\n";
}

struct Mapped {
  Analysis analysis;
  std::vector<EfficiencyMap> maps;
};

Mapped mapped(const std::string& text) {
  SourceFile source;
  source.path = "pair.yaml";
  source.text = text;
  Diagnostics found;
  std::optional<MechanismDescription> description = read_description(source, {}, found);
  std::optional<Loaded> loaded =
      description ? bind_loaded(*std::move(description), found) : std::nullopt;
  if (!loaded) {
    throw std::runtime_error("cannot read the pair");
  }
  Mapped result{.analysis = solve_cases("pair.yaml", *std::move(loaded)), .maps = {}};
  const auto duty = find_duty("pair.yaml", "", judged_file(result.analysis), found);
  if (!duty) {
    throw std::runtime_error("the duty is wrong");
  }
  result.maps = map_duty(result.analysis.mechanism, duty->plan);
  return result;
}

double middle(double high, std::size_t cell, std::size_t count) {
  return high * (static_cast<double>(cell) + 0.5) / static_cast<double>(count);
}

const char* const kPoints =
    "{input_motion: 200 rad/s, input_action: 5 N*m, duration: 9},"
    "{input_motion: 50 rad/s, input_action: 40 N*m, duration: 1},"
    "{input_motion: 0, input_action: 1 N*m, duration: 3}";

// The pinion takes D = 3 N·m of what is given, the teeth lose of the rest: η (T - D)/T.
TEST(EfficiencyMap, IsWhatTeethLeaveOfWhatDragLeaves) {
  const Mapped pair = mapped(pair_text(", friction: {tau: 3 N*m}", kPoints));

  ASSERT_EQ(pair.maps.size(), 1U);
  const EfficiencyMap& map = pair.maps.front();
  EXPECT_EQ(map.speeds.low, 0.0);
  EXPECT_NEAR(map.speeds.high, 200.0, 1e-12);
  EXPECT_EQ(map.loads.low, 0.0);
  EXPECT_NEAR(map.loads.high, 40.0, 1e-12);
  ASSERT_EQ(map.cells.size(), kMapRows * kMapColumns);
  for (std::size_t row = 0; row < kMapRows; ++row) {
    const double torque = middle(40.0, row, kMapRows);
    for (std::size_t column = 0; column < kMapColumns; ++column) {
      const std::optional<double>& cell = map.cells[row * kMapColumns + column];
      if (torque < 3.0) {
        EXPECT_FALSE(cell) << torque;
      } else {
        ASSERT_TRUE(cell) << torque;
        EXPECT_NEAR(*cell, 0.98 * (torque - 3.0) / torque, 1e-12);
      }
    }
  }
  EXPECT_FALSE(map.constant());
}

TEST(EfficiencyMap, HangsOnTheSpeedWhereDragDoes) {
  const Mapped pair = mapped(pair_text(", friction: {c: 0.05 N*m*s/rad}", kPoints));

  ASSERT_EQ(pair.maps.size(), 1U);
  for (std::size_t row = 0; row < kMapRows; ++row) {
    for (std::size_t column = 0; column < kMapColumns; ++column) {
      const double torque = middle(40.0, row, kMapRows);
      const double drag = 0.05 * middle(200.0, column, kMapColumns);
      const std::optional<double>& cell = pair.maps[0].cells[row * kMapColumns + column];
      ASSERT_EQ(cell.has_value(), torque > drag) << torque << " " << drag;
      EXPECT_NEAR(cell.value_or(0.0), std::max(0.98 * (torque - drag) / torque, 0.0), 1e-12);
    }
  }
}

// The wheel drives where the torque is negative, and gives what teeth and drag take: -T/(D - T/η).
TEST(EfficiencyMap, ReachesIntoCoasting) {
  const Mapped pair = mapped(pair_text(
      ", friction: {tau: 3 N*m}",
      std::string(kPoints) + ",{input_motion: 100 rad/s, input_action: -8 N*m, duration: 1}"));

  ASSERT_EQ(pair.maps.size(), 1U);
  const EfficiencyMap& map = pair.maps.front();
  EXPECT_NEAR(map.loads.low, -8.0, 1e-12);
  const double torque = -8.0 + 48.0 * 0.5 / static_cast<double>(kMapRows);
  ASSERT_TRUE(map.cells.front());
  EXPECT_NEAR(*map.cells.front(), -torque / ((3.0 - torque) / 0.98), 1e-12);
}

TEST(EfficiencyMap, KeepsPointsThatMove) {
  const Mapped pair = mapped(pair_text("", kPoints));

  ASSERT_EQ(pair.maps.size(), 1U);
  ASSERT_EQ(pair.maps[0].points.size(), 2U);
  EXPECT_NEAR(pair.maps[0].points[0].speed, 200.0, 1e-12);
  EXPECT_NEAR(pair.maps[0].points[0].load, 5.0, 1e-12);
  EXPECT_EQ(pair.maps[0].points[0].duration, 9.0);
}

TEST(EfficiencyMap, IsANumberWithoutDrag) {
  const Mapped pair = mapped(pair_text("", kPoints));

  ASSERT_EQ(pair.maps.size(), 1U);
  ASSERT_TRUE(pair.maps[0].constant());
  EXPECT_NEAR(*pair.maps[0].constant(), 0.98, 1e-13);
  const Picture picture = draw_efficiency_maps(pair.analysis, pair.maps);
  EXPECT_TRUE(has(picture, ">0.98<"));
  EXPECT_TRUE(has(picture, ">at every speed and torque<"));
  EXPECT_EQ(count_of(picture, "fill-opacity"), 0U);
  EXPECT_EQ(count_of(picture, "<circle"), 0U);
}

TEST(EfficiencyMap, OfADutyAtRestThereIsNone) {
  const Mapped pair = mapped(pair_text("", "{input_motion: 0, input_action: 1 N*m, duration: 3}"));

  EXPECT_TRUE(pair.maps.empty());
}

TEST(MapOfCases, ReachesAQuarterFurther) {
  const Mapped pair = mapped(pair_text(", friction: {tau: 3 N*m}", kPoints));
  const std::size_t which = 0;

  const std::vector<EfficiencyMap> maps = map_cases(pair.analysis.mechanism, std::span(&which, 1));

  ASSERT_EQ(maps.size(), 1U);
  EXPECT_NEAR(maps[0].speeds.high, 125.0, 1e-12);
  EXPECT_NEAR(maps[0].loads.high, 12.5, 1e-12);
  EXPECT_TRUE(maps[0].points.empty());
}

// The first point lasts nine times as long as the second, so that its radius is three times that.
TEST(EfficiencyPicture, DrawsPointsByDuration) {
  const Mapped pair = mapped(pair_text(", friction: {tau: 3 N*m}", kPoints));

  const Picture picture = draw_efficiency_maps(pair.analysis, pair.maps);

  // Two points, and one in the legend that tells how long it lasts.
  EXPECT_EQ(count_of(picture, "<circle"), 3U);
  EXPECT_EQ(count_of(picture, " r=\"7\""), 2U);
  EXPECT_TRUE(has(picture, fmt::format(" r=\"{:.2f}\"", 7.0 / 3.0))) << picture.elements;
  EXPECT_TRUE(has(picture, "this one 9 s"));
}

// Only rows below 3 N·m are empty, each of them one hatched strip.
TEST(EfficiencyPicture, SaysWhatIsHatched) {
  const Mapped with = mapped(pair_text(", friction: {tau: 3 N*m}", kPoints));
  const Mapped without = mapped(pair_text("", kPoints));

  EXPECT_TRUE(has(draw_efficiency_maps(with.analysis, with.maps), "losses exceed"));
  EXPECT_FALSE(has(draw_efficiency_maps(without.analysis, without.maps), "losses exceed"));
}

using Levels = std::vector<double>;

void expect_levels(const Levels& levels, const Levels& expected) {
  ASSERT_EQ(levels.size(), expected.size());
  for (std::size_t i = 0; i < levels.size(); ++i) {
    EXPECT_NEAR(levels[i], expected[i], 1e-12);
  }
}

TEST(EfficiencyLevels, AreRoundLosses) {
  expect_levels(efficiency_levels(0.1, 0.981), {0.5, 0.8, 0.9, 0.95, 0.98});
}

TEST(EfficiencyLevels, AreTheBestSevenOfMany) {
  expect_levels(efficiency_levels(0.1, 0.9985), {0.8, 0.9, 0.95, 0.98, 0.99, 0.995, 0.998});
}

TEST(EfficiencyLevels, AreAtEqualDistancesWhereThereAreFew) {
  expect_levels(efficiency_levels(0.961, 0.9745), {0.962, 0.964, 0.966, 0.968, 0.97, 0.972, 0.974});
}

}  // namespace
}  // namespace kinestat
