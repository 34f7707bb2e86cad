#include "draw/linkage/linkage_drawing.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "draw/linkage/linkage_canvas.hpp"
#include "draw/markup.hpp"
#include "library_analysis.hpp"
#include "unit/plot/picture_text.hpp"

namespace kinestat {
namespace {

TEST(LinkageDrawing, PutsPinsWhereItsScaleSays) {
  const Picture picture = draw_linkage(library_analysis("planar/four_bar.yaml"));
  const double k = attribute(picture, "data-scale");

  // Coupling c stands at (6, 5) m.
  const std::string pin = "cx=\"" + format_coordinate(attribute(picture, "data-x0") + 6 * k) +
                          "\" cy=\"" + format_coordinate(attribute(picture, "data-y0") - 5 * k) +
                          "\"";

  EXPECT_NE(picture.elements.find(pin), std::string::npos) << pin;
}

TEST(LinkageDrawing, HasAGroupForEachBody) {
  const Picture picture = draw_linkage(library_analysis("planar/four_bar.yaml"));

  for (const std::string mark : {"frame-0", "crank-1", "coupler-2", "rocker-3"}) {
    EXPECT_NE(picture.elements.find("data-body=\"" + mark + "\""), std::string::npos) << mark;
  }
}

// The strut of the tailgate stands between (0.1, -0.12) on the ground and (0.35, 0.02) on the lid,
// its cylinder 0.48 - 0.2 m long as far as the rod leaves room; its torsion spring is in the hinge.
TEST(LinkageDrawing, ShowsSpringsWhereTheyEnd) {
  const Picture picture = draw_linkage(library_analysis("planar/tailgate.yaml"));
  const double k = attribute(picture, "data-scale");
  const double x0 = attribute(picture, "data-x0");
  const double y0 = attribute(picture, "data-y0");
  const double share = 0.95;  // 0.28 m would be almost all of it
  const std::string rod = "x1=\"" + format_coordinate(x0 + (0.1 + share * 0.25) * k) + "\" y1=\"" +
                          format_coordinate(y0 - (-0.12 + share * 0.14) * k) + "\" x2=\"" +
                          format_coordinate(x0 + 0.35 * k) + "\" y2=\"" +
                          format_coordinate(y0 - 0.02 * k) + "\"";

  EXPECT_EQ(count_of(picture, "data-spring="), 1U);
  EXPECT_TRUE(has(picture, rod)) << rod;
  EXPECT_TRUE(has(picture, ">strut</text>"));
  EXPECT_TRUE(has(picture, ">torsion</text>"));
}

// What the header says of a moved body, for a body that has turned by θ and moved by (u, v).
TEST(LinkageDrawing, MovesByTheMatrixOfItsHeader) {
  const double angle = 0.7;
  const Vec3 shift(0.3, -1.1, 0.0);
  const LinkageView view{.scale = 80.0, .x0 = 12.0, .y0 = -7.0};
  const Vec3 point(2.0, 1.5, 0.0);
  const Vec3 moved = Eigen::AngleAxisd(angle, Vec3::UnitZ()) * point + shift;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const PixelPoint from = view.at(point);

  const double x = c * from.x + s * from.y + view.x0 * (1 - c) - view.y0 * s + view.scale * 0.3;
  const double y = -s * from.x + c * from.y + view.y0 * (1 - c) + view.x0 * s + view.scale * 1.1;

  EXPECT_NEAR(x, view.at(moved).x, 1e-9);
  EXPECT_NEAR(y, view.at(moved).y, 1e-9);
}

TEST(LinkageDrawing, HoldsThePathsAndPlacesOfAMotion) {
  const Analysis analysis = library_analysis("planar/four_bar.yaml");
  LinkageOptions options;
  options.reach = {Vec3(-20.0, 0.0, 0.0), Vec3(0.0, 30.0, 0.0)};
  options.paths = {{.name = "coupler point",
                    .points = {Vec3(3.0, 9.0, 0.0), Vec3(4.0, 12.0, 0.0)},
                    .body = BodyId{2}}};

  const Picture picture = draw_linkage(analysis, options);

  const double k = attribute(picture, "data-scale");
  EXPECT_LE(picture.view.left, attribute(picture, "data-x0") - 20.0 * k);
  EXPECT_LE(picture.view.top, attribute(picture, "data-y0") - 30.0 * k);
  EXPECT_NE(picture.elements.find("coupler point"), std::string::npos);
}

// Cazangi 2008, eq. 3.96: the force in b is (5/27, 2/27) N, 0.1994 N long.
TEST(LinkageDrawing, WritesTheForcesOfACase) {
  LinkageOptions options;
  options.which = 0;

  const Picture picture = draw_linkage(library_analysis("planar/four_bar.yaml"), options);

  EXPECT_NE(picture.elements.find("0.1995 N"), std::string::npos);
  EXPECT_EQ(draw_linkage(library_analysis("planar/four_bar.yaml")).elements.find("0.1995 N"),
            std::string::npos);
}

TEST(LinkageDrawing, EscapesTheLabelsOfCases) {
  Analysis analysis = library_analysis("planar/four_bar.yaml");
  analysis.cases[0].which.label = "<script>\"x\"]]>";
  LinkageOptions options;
  options.which = 0;

  const Picture picture = draw_linkage(analysis, options);

  EXPECT_EQ(picture.elements.find("<script>"), std::string::npos);
  EXPECT_EQ(picture.elements.find("]]>"), std::string::npos);
}

// The open belt touches its pulleys, of radius 40 and 90 mm and 300 mm apart, along a line whose
// slope has the sine (90 - 40)/300.
TEST(LinkageParts, LeadRopesAlongTangents) {
  const Analysis analysis = library_analysis("cables/open_belt.yaml");

  const LinkageParts parts = find_linkage_parts(analysis.description, analysis.mechanism);

  ASSERT_EQ(parts.spans.size(), 2U);
  ASSERT_EQ(parts.arcs.size(), 2U);
  for (const CableLine& span : parts.spans) {
    const Vec3 along = span.to - span.from;
    EXPECT_NEAR(std::abs(along.y()) / along.norm(), 1.0 / 6.0, 1e-12);
    EXPECT_NEAR(along.norm(), std::sqrt(0.3 * 0.3 - 0.05 * 0.05), 1e-12);
  }
}

// Willis' set: sun of 24 teeth, planet of 18, ring of 60, module 1: radii 12, 9 and 30.
TEST(LinkageParts, FindThePitchCirclesOfGears) {
  const Analysis analysis = library_analysis("gears/simple_planetary.yaml");

  const LinkageParts parts = find_linkage_parts(analysis.description, analysis.mechanism);

  ASSERT_EQ(parts.wheels.size(), 3U);
  for (const Wheel& wheel : parts.wheels) {
    const std::string& name = analysis.mechanism.topology.body(wheel.body).name;
    const double radius = name == "sun" ? 12.0 : name == "ring" ? 30.0 : 9.0;
    EXPECT_NEAR(wheel.radius, radius, 1e-9) << name;
    EXPECT_EQ(wheel.kind == WheelKind::ring, name == "ring");
  }
}

}  // namespace
}  // namespace kinestat
