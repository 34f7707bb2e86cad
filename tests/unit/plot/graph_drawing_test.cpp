#include "draw/graph/graph_drawing.hpp"

#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "draw/graph/graph_writer.hpp"
#include "library_analysis.hpp"

namespace kinestat {
namespace {

TEST(PowerWidth, GrowsWithThePower) {
  double last = 0.0;
  for (const double power : {20.0, 40.0, 60.0, 100.0}) {
    const double width = power_width(power, 100.0);
    EXPECT_GT(width, last);
    last = width;
  }
}

TEST(PowerWidth, IsProportionalToThePower) {
  EXPECT_DOUBLE_EQ(power_width(100.0, 100.0), 2.0 * power_width(50.0, 100.0));
}

TEST(PowerWidth, IsAHairWithoutAny) {
  EXPECT_GT(power_width(0.0, 0.0), 0.0);
  EXPECT_LT(power_width(0.0, 100.0), 2.0);
}

// In first gear a freewheel locks the rear set: what its sun gives back runs through the freewheel
// to the carrier again.
TEST(PowerModel, MarksPowerThatGoesInACircle) {
  const Analysis analysis = library_analysis("transmissions/simpson_4hp22.yaml");

  const GraphModel model = power_model(analysis, 0);

  std::set<std::string> circle;
  for (std::size_t e = 0; e < model.edges.size(); ++e) {
    if (model.power[e].recirculates) {
      circle.insert(model.edges[e].label);
    }
  }
  EXPECT_EQ(circle, (std::set<std::string>{"F", "P0", "s0"}));
}

// Cazangi 2008, Fig. 5.18: from sun 1 by planet 5 to the carrier 150.8 W, on to planet 6, of which
// 50.8 W return to planet 5. Torque times speed of the shafts has no circle there: planets that
// mesh with each other count as one.
TEST(PowerModel, SeesNoCircleInPlanetsThatMeshWithEachOther) {
  const GraphModel model = power_model(library_analysis("transmissions/ravigneaux.yaml"), 1);

  EXPECT_TRUE(std::ranges::none_of(model.power, &ModelPower::recirculates));
}

// The same figure: input at a, output at d, and no power in b, c, e and j.
TEST(PowerModel, FollowsThePowerFromInputToOutput) {
  const Analysis analysis = library_analysis("transmissions/ravigneaux.yaml");

  const GraphModel model = power_model(analysis, 1);

  const auto power = [&](const std::string& label) {
    const auto at = std::ranges::find(model.edges, label, &ModelEdge::label);
    return model.power[static_cast<std::size_t>(at - model.edges.begin())];
  };
  EXPECT_NEAR(power("a").size, 100.0, 1e-9);
  EXPECT_TRUE(power("a").is_forward);
  EXPECT_NEAR(power("f").size, 4675.0 / 31.0, 1e-9);
  EXPECT_FALSE(power("f").is_forward);
  EXPECT_NEAR(power("d").size, 100.0, 1e-9);
  EXPECT_FALSE(power("d").is_forward);
  EXPECT_EQ(power("b").size, 0.0);
  EXPECT_EQ(power("j").size, 0.0);
}

// Each leg of the platform drives between two bodies that move or may; what the six give is what
// the weight takes, and nothing else enters.
TEST(PowerModel, ShowsWhatDrivesBetweenMovingBodies) {
  const GraphModel model = power_model(library_analysis("spatial/ups_platform.yaml"), 0);
  double given = 0.0;
  double taken = 0.0;
  int drives = 0;
  for (const ModelPort& port : model.ports) {
    (port.enters ? given : taken) += port.size;
    drives += port.enters ? 1 : 0;
  }

  EXPECT_EQ(drives, 6);
  EXPECT_GT(taken, 0.0);
  EXPECT_NEAR(given, taken, 1e-9 * taken);
}

// Cazangi 2008, eq. 5.10: circuit h is a - e - f + h.
TEST(CircuitModels, NameTheirEdgesWithSigns) {
  const Analysis analysis = library_analysis("transmissions/ravigneaux.yaml");

  const std::vector<GraphModel> circuits = circuit_models(analysis);

  ASSERT_EQ(circuits.size(), 5U);
  EXPECT_EQ(circuits[1].title, "Circuit h: h − f − e + a");
}

// Eq. 5.8: cut-set c is c - d + k.
TEST(CutsetModels, NameTheirEdgesWithSigns) {
  const Analysis analysis = library_analysis("transmissions/ravigneaux.yaml");

  const std::vector<GraphModel> cutsets = cutset_models(analysis);

  ASSERT_EQ(cutsets.size(), 6U);
  EXPECT_EQ(cutsets[2].title, "Cut-set c: c − d + k");
}

// Cazangi 2008, Fig. 5.11 and eq. 5.16: 39 constraint units, of which b has seven.
TEST(ActionGraph, HasALineForEachConstraint) {
  const Analysis analysis = library_analysis("transmissions/ravigneaux.yaml");

  const GraphModel model = action_graph_model(analysis);

  int lines = 0;
  for (const ModelEdge& edge : model.edges) {
    lines += edge.lines;
  }
  EXPECT_EQ(lines, 39);
  EXPECT_EQ(model.edges[1].label, "b: Rx Ry Rz Tx Ty C2 B1");
}

TEST(GraphDrawing, EscapesNames) {
  GraphModel model{.name = "graph",
                   .title = "<b>",
                   .nodes = {{.name = "a<b>&"}, {.name = "c"}},
                   .edges = {{.tail = 0, .head = 1, .label = "<script>"}},
                   .power = {},
                   .ports = {}};

  const std::string elements = draw_graph(model).elements;

  EXPECT_EQ(elements.find("<script>"), std::string::npos);
  EXPECT_NE(elements.find("a&lt;b&gt;&amp;"), std::string::npos);
}

}  // namespace
}  // namespace kinestat
