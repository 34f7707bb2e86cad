#include "draw/svg.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/contract.hpp"
#include "unit/plot/picture_text.hpp"

namespace kinestat {
namespace {

bool has(const Svg& svg, const std::string& text) {
  return svg.elements().find(text) != std::string::npos;
}

TEST(Svg, EscapesTextAndTitles) {
  Svg svg;
  svg.open_group("<b>");
  svg.text({.x = 0.0, .y = 0.0}, "</text><script>", {});
  svg.close_group();

  EXPECT_FALSE(has(svg, "<script>"));
  EXPECT_TRUE(has(svg, "&lt;/text&gt;&lt;script&gt;"));
  EXPECT_TRUE(has(svg, "<title>&lt;b&gt;</title>"));
}

TEST(Svg, EscapesAttributes) {
  Svg svg;
  const std::vector<Attribute> attributes = {{"data-name", "\" onload=\"x"}};
  svg.open_group("", attributes);
  svg.close_group();

  EXPECT_TRUE(has(svg, "data-name=\"&quot; onload=&quot;x\""));
}

TEST(Svg, BreaksLinesAtGaps) {
  Svg svg;
  const std::vector<PixelPoint> points = {
      {.x = 0, .y = 0}, {.x = 1, .y = 1}, {.x = kGap, .y = 2}, {.x = 3, .y = 3}, {.x = 4, .y = 4}};
  svg.polyline(points, {});

  EXPECT_TRUE(has(svg, "d=\"M0,0L1,1M3,3L4,4\""));
}

TEST(Svg, DrawsAPointBetweenGapsAsADot) {
  Svg svg;
  const std::vector<PixelPoint> points = {
      {.x = kGap, .y = 0}, {.x = 2, .y = 2}, {.x = 1, .y = kGap}};
  svg.polyline(points, {});

  EXPECT_TRUE(has(svg, "d=\"M2,2h0.01\""));
}

TEST(Svg, DrawsNothingOfGapsAlone) {
  Svg svg;
  const std::vector<PixelPoint> points = {{.x = kGap, .y = kGap}};
  svg.polyline(points, {});

  EXPECT_TRUE(svg.elements().empty());
  EXPECT_TRUE(svg.bounds().is_empty());
}

TEST(Svg, RefusesShapesThatAreNotFinite) {
  Svg svg;

  EXPECT_THROW(svg.line({.x = kGap, .y = 0.0}, {.x = 1.0, .y = 0.0}, {}), ContractViolation);
  EXPECT_THROW(svg.circle({.x = 0.0, .y = 0.0}, std::numeric_limits<double>::infinity(), {}),
               ContractViolation);
}

TEST(Svg, KnowsWhereItsShapesLie) {
  Svg svg;
  svg.circle({.x = 10.0, .y = 20.0}, 5.0, {.stroke = Ink::ink, .width = 2.0});

  EXPECT_DOUBLE_EQ(svg.bounds().left, 4.0);
  EXPECT_DOUBLE_EQ(svg.bounds().bottom, 26.0);
}

TEST(Svg, KnowsWhereTurnedTextLies) {
  const PixelBox box = text_box(
      {.x = 0.0, .y = 0.0}, "length", {.size = 10.0, .anchor = Anchor::middle, .turn = -90.0});

  EXPECT_NEAR(box.height(), text_width("length", 10.0), 1e-12);
  EXPECT_NEAR(box.width(), 10.0, 1e-12);
}

TEST(Svg, HatchesWithinTheBox) {
  Svg svg;
  const PixelBox box = {.left = 10.0, .top = 20.0, .right = 40.0, .bottom = 31.0};
  svg.hatch(box, Ink::ink);

  EXPECT_GE(svg.bounds().left, box.left);
  EXPECT_LE(svg.bounds().bottom, box.bottom);
}

TEST(Svg, DrawsOnlyTheHeadOfAShortArrow) {
  Svg svg;
  svg.arrow({.x = 0.0, .y = 0.0}, {.x = 3.0, .y = 0.0}, {}, 8.0);

  EXPECT_FALSE(has(svg, "<line"));
  EXPECT_TRUE(has(svg, "<polygon points=\"3,0 "));
}

TEST(Svg, MakesOnePathOfLinesOfOnePaint) {
  Svg svg;
  const Paint grid = {.stroke = Ink::grid, .width = 1.0};
  svg.line({.x = 0.0, .y = 0.0}, {.x = 5.0, .y = 0.0}, grid);
  EXPECT_TRUE(has(svg, "<line x1=\"0\""));
  svg.line({.x = 1.0, .y = 2.0}, {.x = 1.0, .y = 7.5}, grid);
  svg.line({.x = 1.0, .y = 2.0}, {.x = 3.0, .y = 4.0}, grid);
  EXPECT_TRUE(has(svg, "<path d=\"M0,0H5M1,2V7.5M1,2L3,4\" "));
  EXPECT_FALSE(has(svg, "<line"));
  svg.line({.x = 1.0, .y = 2.0}, {.x = 3.0, .y = 4.0}, {.stroke = Ink::ink});
  EXPECT_TRUE(has(svg, "<line x1=\"1\""));
}

// What lies between them would come to lie below or above both.
TEST(Svg, JoinsNothingAcrossOtherElements) {
  Svg svg;
  svg.line({.x = 0.0, .y = 0.0}, {.x = 5.0, .y = 0.0}, {});
  svg.circle({.x = 0.0, .y = 0.0}, 1.0, {});
  svg.line({.x = 1.0, .y = 2.0}, {.x = 1.0, .y = 7.5}, {});
  svg.open_group();
  svg.line({.x = 1.0, .y = 2.0}, {.x = 1.0, .y = 7.5}, {});
  svg.close_group();

  EXPECT_FALSE(has(svg, "<path"));
}

TEST(Svg, MakesOnePathOfFilledRectanglesButNotOfOthers) {
  const PixelBox one = {.left = 1.0, .top = 2.0, .right = 4.0, .bottom = 4.0};
  const PixelBox other = {.left = 5.0, .top = 2.0, .right = 6.0, .bottom = 4.0};
  const Paint blue = {.stroke = Ink::none, .fill = Ink::blue};
  Svg filled;
  filled.rectangle(one, blue);
  filled.rectangle(other, blue);
  EXPECT_TRUE(has(filled, "<path d=\"M1,2h3v2h-3zM5,2h1v2h-1z\" "));
  for (const Paint& paint : {Paint{.stroke = Ink::ink, .fill = Ink::blue},
                             Paint{.stroke = Ink::none, .fill = Ink::blue, .opacity = 0.5}}) {
    Svg apart;
    apart.rectangle(one, paint);
    apart.rectangle(other, paint);
    EXPECT_FALSE(has(apart, "<path"));
  }
}

TEST(Svg, SaysTheStyleOfTextsOnce) {
  Svg svg;
  svg.text({.x = 1.0, .y = 2.0}, "a", {.size = 11.0, .anchor = Anchor::end});
  svg.text({.x = 3.0, .y = 4.0}, "b", {.size = 11.0, .anchor = Anchor::end});

  EXPECT_TRUE(has(svg, "<g font-size=\"11\" text-anchor=\"end\""));
  EXPECT_TRUE(has(svg, "<text x=\"1\" y=\"2\">a</text>\n<text x=\"3\" y=\"4\">b</text>\n</g>"));
}

TEST(Svg, WritesColumnsAndKnowsWhereTheyLie) {
  Svg svg;
  const std::vector<std::pair<double, std::string>> texts = {{20.0, "12"}, {40.0, "<"}};
  svg.column(100.0, texts, {.size = 10.0, .anchor = Anchor::end});

  EXPECT_TRUE(has(svg, "<g transform=\"translate(100)\" "));
  EXPECT_TRUE(has(svg, "<text y=\"40\">&lt;</text>"));
  EXPECT_DOUBLE_EQ(svg.bounds().right, 100.0);
  EXPECT_DOUBLE_EQ(svg.bounds().left, 100.0 - text_width("12", 10.0));
}

TEST(Svg, WantsItsGroupsClosed) {
  Svg svg;
  svg.open_group();

  EXPECT_THROW(static_cast<void>(svg.elements()), ContractViolation);
}

TEST(PixelBox, OverlapsOnlyWhereAreasDo) {
  const PixelBox box = {.left = 0.0, .top = 0.0, .right = 2.0, .bottom = 2.0};

  EXPECT_TRUE(box.overlaps({.left = 1.0, .top = 1.0, .right = 3.0, .bottom = 3.0}));
  EXPECT_FALSE(box.overlaps({.left = 2.0, .top = 0.0, .right = 3.0, .bottom = 2.0}));
}

TEST(Svg, KeepsTheLinesThatAreSeen) {
  Svg svg;
  svg.line({.x = 0.0, .y = 0.0}, {.x = 9.0, .y = 0.0}, {.stroke = Ink::ink});
  svg.keep_lines();
  svg.line({.x = 0.0, .y = 0.0}, {.x = 9.0, .y = 0.0}, {.stroke = Ink::grid});
  svg.rectangle({.left = 0.0, .top = 0.0, .right = 4.0, .bottom = 4.0},
                {.stroke = Ink::none, .fill = Ink::paper});
  const std::vector<Attribute> hidden = {{"display", "none"}};
  svg.open_group({}, hidden);
  svg.line({.x = 0.0, .y = 0.0}, {.x = 9.0, .y = 0.0}, {.stroke = Ink::ink});
  svg.close_group();
  EXPECT_TRUE(svg.lines().empty());

  svg.rectangle({.left = 0.0, .top = 0.0, .right = 4.0, .bottom = 4.0}, {.stroke = Ink::blue});

  EXPECT_EQ(svg.lines().size(), 4U);
}

// By both edges, between which no letter fits.
TEST(Svg, KeepsTheEdgesOfWideLines) {
  Svg svg;
  svg.keep_lines();

  svg.line({.x = 0.0, .y = 0.0}, {.x = 9.0, .y = 0.0}, {.stroke = Ink::ink, .width = 8.0});

  ASSERT_EQ(svg.lines().size(), 2U);
  EXPECT_EQ(std::abs(svg.lines()[0].from.y), 4.0);
  EXPECT_EQ(svg.lines()[0].from.y, -svg.lines()[1].from.y);
}

}  // namespace
}  // namespace kinestat
