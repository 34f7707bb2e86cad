#include "draw/bar_map.hpp"

#include <gtest/gtest.h>

#include "core/contract.hpp"
#include "unit/plot/picture_text.hpp"

namespace kinestat {
namespace {

BarMap map_of(std::vector<BarRow> rows, std::vector<std::string> columns) {
  return {.name = "demo",
          .title = "t",
          .mechanism = "m",
          .description = "d",
          .columns = std::move(columns),
          .blocks = {{.title = "force [N]", .rows = std::move(rows)}},
          .remarks = {}};
}

TEST(BarMap, HasABarForWhatIsNotZero) {
  const Picture picture = draw_bar_map(map_of(
      {{.name = "a", .values = {3.0, 0.0}}, {.name = "b", .values = {{}, 2.0}}}, {"M1", "M2"}));

  EXPECT_EQ(count_of(picture, "v11h-"), 2U);  // one path of both
  EXPECT_EQ(count_of(picture, ">–<"), 1U);
}

// The larger value fills the scale; half of it is half as long.
TEST(BarMap, HasOneScaleForAllCases) {
  const Picture picture = draw_bar_map(map_of({{.name = "a", .values = {8.0, 4.0}}}, {"M1", "M2"}));

  EXPECT_EQ(count_of(picture, "h88v11h-88z"), 1U);
  EXPECT_EQ(count_of(picture, "h44v11h-44z"), 1U);
}

TEST(BarMap, HatchesNegativeValues) {
  const Picture positive = draw_bar_map(map_of({{.name = "a", .values = {8.0}}}, {"M1"}));
  const Picture negative = draw_bar_map(map_of({{.name = "a", .values = {-8.0}}}, {"M1"}));

  EXPECT_EQ(count_of(positive, "<path"), 0U);
  EXPECT_EQ(count_of(negative, "<path"), 1U);
}

// Rows and columns head what is whole; a name that is cut is told where it is pointed at.
TEST(BarMap, TellsNamesThatAreCut) {
  const std::string name(60, 'w');
  const Picture picture = draw_bar_map(
      map_of({{.name = name, .values = {8.0}}, {.name = "a", .values = {4.0}}}, {"M1"}));

  EXPECT_EQ(count_of(picture, "<title>" + name + "</title>"), 1U);
  EXPECT_EQ(count_of(picture, "<title>"), 1U);
}

TEST(BarMap, LeavesSmallValuesOfManyOut) {
  std::vector<BarRow> rows;
  for (int i = 0; i < 100; ++i) {
    rows.push_back({.name = "row" + std::to_string(i), .values = {static_cast<double>(i)}});
  }

  const Picture picture = draw_bar_map(map_of(std::move(rows), {"M1"}));

  EXPECT_EQ(count_of(picture, ">row99<"), 1U);
  EXPECT_EQ(count_of(picture, ">row39<"), 0U);
  EXPECT_EQ(count_of(picture, ">and 40 with smaller values<"), 1U);
}

// Rows are 19 px high; one line takes the place of the four.
TEST(BarMap, SumsUpManyRowsOfZeros) {
  std::vector<BarRow> rows = {{.name = "a", .values = {8.0, 0.0}}};
  for (const char* name : {"b", "c", "d"}) {
    rows.push_back({.name = name, .values = {0.0, 0.0}});
  }
  const Picture few = draw_bar_map(map_of(rows, {"M1", "M2"}));
  rows.push_back({.name = "unknown", .values = {0.0, {}}});
  rows.push_back({.name = "e", .values = {0.0, 0.0}});
  const Picture many = draw_bar_map(map_of(rows, {"M1", "M2"}));

  EXPECT_EQ(count_of(few, ">d<"), 1U);
  EXPECT_EQ(count_of(many, ">d<"), 0U);
  EXPECT_EQ(count_of(many, ">unknown<"), 1U);
  EXPECT_EQ(count_of(many, ">0 in b, c, d, e<"), 1U);
}

TEST(BarMap, PutsManyCasesBelowEachOther) {
  const std::vector<std::string> labels = {"1", "2", "3", "4", "5", "6", "7", "8", "R"};
  const Picture picture = draw_bar_map(
      map_of({{.name = "a", .values = std::vector<std::optional<double>>(9, 1.0)}}, labels));

  EXPECT_LT(picture.view.width(), 1200.0);
  EXPECT_EQ(count_of(picture, ">R<"), 1U);
}

// Names of 40 px and 12 beside them leave 314 px of 366: room for two cells of 138, the last
// without the 14 to the next. The larger value, in another part, fills the scale of 56 px.
TEST(BarMap, ComesInPartsOfOneScaleThatFitATelephone) {
  const std::vector<Picture> parts = draw_bar_map_in_parts(
      map_of({{.name = "a", .values = {8.0, 4.0, 2.0}}, {.name = "b", .values = {1.0, 1.0, 4.0}}},
             {"M1", "M2", "M3"}));

  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].title, "t, M1, M2: m");
  EXPECT_EQ(parts[1].title, "t, M3: m");
  EXPECT_EQ(count_of(parts[0], "h56v11h-56z"), 1U);
  EXPECT_EQ(count_of(parts[1], "h14v11h-14z"), 1U);
  for (const Picture& part : parts) {
    EXPECT_LT(part.view.width(), 378.0);
  }
}

// A single case has room for longer bars.
TEST(BarMap, IsOnePartOfOneCase) {
  const std::vector<Picture> parts = draw_bar_map_in_parts(
      map_of({{.name = "a", .values = {8.0}}, {.name = "b", .values = {4.0}}}, {"M1"}));

  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].title, "t: m");
  EXPECT_EQ(count_of(parts[0], "h88v11h-88z"), 1U);
}

TEST(BarMap, WantsAValueForEachCase) {
  EXPECT_THROW(draw_bar_map(map_of({{.name = "a", .values = {1.0}}}, {"M1", "M2"})),
               ContractViolation);
}

}  // namespace
}  // namespace kinestat
