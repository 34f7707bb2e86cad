#include "draw/picture.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "unit/plot/picture_text.hpp"

namespace kinestat {
namespace {

Picture picture_with_id() {
  Svg svg;
  const std::vector<Attribute> attributes = {{"id", Svg::id("crank")}};
  svg.open_group("", attributes);
  svg.line({.x = 0.0, .y = 0.0}, {.x = 10.0, .y = 5.0}, {});
  svg.close_group();
  return make_picture("demo", "Title <1>", "Description & more", svg);
}

TEST(Picture, HasIdsOfItsPlaceOnAPage) {
  const Picture picture = picture_with_id();

  EXPECT_TRUE(has(svg_element(picture, "p1"), "<g id=\"p1-crank\">"));
  EXPECT_TRUE(has(svg_element(picture, "p2"), "<g id=\"p2-crank\">"));
  EXPECT_FALSE(has(svg_file(picture), std::string(kIdMark)));
}

TEST(Picture, EscapesTitleAndDescription) {
  const std::string file = svg_file(picture_with_id());

  EXPECT_TRUE(has(file, "aria-label=\"Title &lt;1&gt;\""));
  EXPECT_TRUE(has(file, "<title>Title &lt;1&gt;</title>"));
  EXPECT_TRUE(has(file, "<desc>Description &amp; more</desc>"));
}

TEST(Picture, OnAPageHasNoStyleAndNoTitleInSight) {
  const std::string element = svg_element(picture_with_id(), "p");

  EXPECT_FALSE(has(element, "<style"));
  EXPECT_FALSE(has(element, "style="));
  EXPECT_FALSE(has(element, "<text"));
}

TEST(Picture, AsAFileIsLightOrDark) {
  const std::string file = svg_file(picture_with_id());

  EXPECT_TRUE(file.starts_with(svg_signature()));
  EXPECT_TRUE(has(file, "prefers-color-scheme:dark"));
}

TEST(Picture, HasAViewAroundEverything) {
  const Picture picture = picture_with_id();

  EXPECT_LE(picture.view.left, -12.0);
  EXPECT_GE(picture.view.right, 22.0);
}

// The mark of ids is a control character; in a text of a user it is none.
TEST(Picture, DoesNotTakeTextsForIds) {
  Svg svg;
  svg.text({.x = 0.0, .y = 0.0}, std::string(kIdMark) + "x", {});
  const std::vector<Attribute> attributes = {{"data-name", std::string(kIdMark) + "y"}};
  svg.open_group(std::string(kIdMark) + "z", attributes);
  svg.close_group();

  const std::string element = svg_element(make_picture("demo", "t", "d", svg), "prefix");

  EXPECT_FALSE(has(element, "prefix-"));
}

}  // namespace
}  // namespace kinestat
