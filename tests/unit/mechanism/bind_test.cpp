#include "mechanism/bind/bind.hpp"

#include <gtest/gtest.h>

#include "format/mechanism_reader.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {
namespace {

// Reads and binds a text; a test that expects errors looks at `found`.
struct Bound {
  Diagnostics found;
  std::optional<MechanismDescription> description;
  std::optional<Mechanism> mechanism;

  explicit Bound(const std::string& text) {
    const auto tree = read_yaml({.path = "test.yaml", .text = text}, ReadLimits{}, found);
    description = tree ? read_mechanism(*tree, found) : std::nullopt;
    mechanism = description ? bind(*description, found) : std::nullopt;
  }

  std::vector<std::string> codes() const {
    std::vector<std::string> result;
    for (const Diagnostic& one : found.items()) {
      result.emplace_back(one.code);
    }
    return result;
  }
};

using Codes = std::vector<std::string>;

// A planar chain frame - crank - rod, with room for further keys and sections.
std::string chain(const std::string& first_keys = "", const std::string& sections = "") {
  return "kinestat: 1\nspace: planar\nunits: {length: mm}\nground: frame\nbodies: [crank, rod]\n"
         "couplings:\n"
         "  a: {type: revolute, bodies: [frame, crank], at: [0, 0]" +
         first_keys +
         "}\n"
         "  b: {type: revolute, bodies: [crank, rod], at: [30, 40]}\n" +
         sections;
}

TEST(Bind, ConvertsBareNumbersFromTheUnitsOfTheFile) {
  const Bound bound(chain());

  ASSERT_TRUE(bound.mechanism);
  EXPECT_EQ(bound.mechanism->geometry.points[1], Vec3(0.03, 0.04, 0.0));
  EXPECT_EQ(bound.mechanism->geometry.motions[1].linear, Vec3(0.04, -0.03, 0.0));
}

TEST(Bind, TakesTheDiagonalOfAllPointsAsLength) {
  const Bound bound(chain());

  ASSERT_TRUE(bound.mechanism);
  EXPECT_DOUBLE_EQ(bound.mechanism->geometry.length, 0.05);
}

TEST(Bind, ReportsABodyAtItsFirstCouplingUnlessItSaysWhere) {
  Bound bound(chain());
  ASSERT_TRUE(bound.mechanism);
  EXPECT_EQ(bound.mechanism->geometry.references[2], Vec3(0.03, 0.04, 0.0));

  const Bound given(
      "kinestat: 1\nspace: planar\nground: frame\nbodies: {crank: {reference: [7, 8]}}\n"
      "couplings: {a: {type: revolute, bodies: [frame, crank], at: [1, 2]}}\n");
  ASSERT_TRUE(given.mechanism);
  EXPECT_EQ(given.mechanism->geometry.references[1], Vec3(7.0, 8.0, 0.0));
}

// A double has 10 digits of a metre left there; differences of the numbers as typed have all.
TEST(Bind, KeepsTheDigitsBetweenPointsFarFromTheWorldOrigin) {
  const Bound bound(
      "kinestat: 1\nspace: planar\nparameters: {far: 1e6}\nground: frame\n"
      "bodies: {crank: {reference: [far + 0.7, 0]}, rod: {}}\n"
      "couplings:\n"
      "  a: {type: revolute, bodies: [frame, crank], at: [far + 0.1, 0]}\n"
      "  b: {type: revolute, bodies: [crank, rod], at: [far + 0.4, 0]}\n"
      "loads: {push: {body: rod, at: [far + 0.8, 0], force: [0, 10]}}\n"
      "cases: {one: {action: {}}}\n");

  ASSERT_TRUE(bound.mechanism);
  const Geometry& geometry = bound.mechanism->geometry;
  EXPECT_NEAR(geometry.origin.place().x(), 1e6 + 0.25, 1e-9);
  EXPECT_NEAR(geometry.points[1].x() - geometry.points[0].x(), 0.3, 1e-16);
  EXPECT_NEAR(geometry.motions[1].linear.y() - geometry.motions[0].linear.y(), -0.3, 1e-16);
  EXPECT_NEAR(geometry.references[1].x() - geometry.points[1].x(), 0.3, 1e-16);
  const Load& push = bound.mechanism->cases[0].loads[0];
  EXPECT_NEAR(push.acts.wrench.moment.z() - 10.0 * geometry.points[0].x(), 7.0, 2e-15);
}

TEST(Bind, PutsTheActionsOfActuatorsBehindTheConstraintsOfTheirCoupling) {
  const Bound bound(
      chain("", "actuators: {late: {coupling: b}, T1: {coupling: a}, T2: {coupling: a}}\n"));
  ASSERT_TRUE(bound.mechanism);
  const Topology& topology = bound.mechanism->topology;

  std::vector<std::string> names;
  for (int i = 0; i < topology.action_count(); ++i) {
    names.push_back(topology.action_name(i));
  }

  EXPECT_EQ(names, Codes({"a.Rx", "a.Ry", "T1", "T2", "b.Rx", "b.Ry", "late"}));
}

TEST(Bind, MakesAClutchAnActuatorOfItsOwnName) {
  const Bound bound(
      "kinestat: 1\nspace: planar\nground: frame\nbodies: [shaft]\ncouplings:\n"
      "  s: {type: revolute, bodies: [frame, shaft], at: [0, 0]}\n"
      "  B: {type: brake, bodies: [frame, shaft], at: [0, 0]}\n"
      "cases: {held: {motion: {B: 0}, action: {B: 3 N*m}}}\n");

  ASSERT_TRUE(bound.mechanism);
  ASSERT_EQ(bound.mechanism->topology.actuators.size(), 1U);
  EXPECT_EQ(bound.mechanism->topology.actuators[0].name, "B");
  EXPECT_EQ(bound.mechanism->cases[0].motions[0].index, 1);
  EXPECT_EQ(bound.mechanism->cases[0].actions[0].value, 3.0);
}

TEST(Bind, KeepsOnlyTheConstraintsNamedAsPassive) {
  const Bound bound(chain(", passive: [Ry]"));

  ASSERT_TRUE(bound.mechanism);
  EXPECT_EQ(bound.mechanism->topology.couplings[0].action_count, 1);
  EXPECT_EQ(bound.mechanism->topology.action_name(0), "a.Ry");
}

TEST(Bind, InSpaceGivesPlanarCouplingsTheirSpatialConstraints) {
  const Bound bound(chain());
  Diagnostics found;
  ASSERT_TRUE(bound.description);

  const std::optional<Mechanism> in_space = bind_in_space(*bound.description, found);

  ASSERT_TRUE(in_space);
  EXPECT_EQ(bound.mechanism->topology.action_count(), 4);
  EXPECT_EQ(in_space->topology.action_count(), 10);
  EXPECT_EQ(in_space->topology.freedom_count(), bound.mechanism->topology.freedom_count());
}

TEST(Bind, TakesTheSpatialConstraintsWhenTheStaticOrderIsSpatial) {
  const Bound bound(chain("", "order: {statics: spatial}\n"));

  ASSERT_TRUE(bound.mechanism);
  EXPECT_EQ(bound.mechanism->topology.action_count(), 10);
}

TEST(Bind, GivesAGearTheForceOfItsPressureAngle) {
  // n = cos α t + sin α (axis x t) with t = x, axis = z: (cos 20°, sin 20°), Cazangi 2008,
  // Eq. 5.15.
  const Bound bound(
      "kinestat: 1\nground: frame\nbodies: [sun, planet]\ncouplings:\n"
      "  a: {type: revolute, bodies: [frame, sun], at: [0, 0, 0], axis: z}\n"
      "  b: {type: revolute, bodies: [frame, planet], at: [0, 17, 0], axis: z}\n"
      "  h: {type: gear, bodies: [sun, planet], at: [0, 9.5, 0], axis: z, tangent: x, "
      "pressure_angle: 20 deg}\n");

  ASSERT_TRUE(bound.mechanism);
  const Vec3 force = bound.mechanism->geometry.actions.back().force;
  EXPECT_NEAR(force.x(), 0.93969262078590838, 1e-15);
  EXPECT_NEAR(force.y(), 0.34202014332566873, 1e-15);
  EXPECT_EQ(force.z(), 0.0);
}

TEST(Bind, TakesTheFirstCouplingsThatCloseNoCircuitAsTree) {
  const Bound bound(chain("", "  c: {type: revolute, bodies: [frame, rod], at: [70, 0]}\n"));

  ASSERT_TRUE(bound.mechanism);
  EXPECT_EQ(bound.mechanism->graph.tree.branches, std::vector<int>({0, 1}));
  EXPECT_EQ(bound.mechanism->graph.tree.chords, std::vector<int>({2}));
}

struct Mistake {
  const char* name;
  const char* keys;
  const char* sections;
  const char* code;
};

class BindMistake : public testing::TestWithParam<Mistake> {};

TEST_P(BindMistake, IsAnsweredByItsCode) {
  const Bound bound(chain(GetParam().keys, GetParam().sections));

  EXPECT_FALSE(bound.mechanism);
  EXPECT_EQ(bound.codes(), Codes({GetParam().code}));
}

INSTANTIATE_TEST_SUITE_P(
    OneEach,
    BindMistake,
    testing::Values(
        Mistake{"BodyJoinedToItself", "", "  c: {type: rigid, bodies: [rod, rod]}\n", "E0312"},
        Mistake{"PlanarRevoluteAboutX", ", axis: x", "", "E0314"},
        Mistake{"SliderWithoutAxis", "", "  c: {type: prismatic, bodies: [frame, rod]}\n", "E0314"},
        Mistake{"GearWithoutDirection",
                "",
                "  c: {type: gear, bodies: [frame, rod], at: [1, 2]}\n",
                "E0314"},
        Mistake{"GearWithTwoDirections",
                "",
                "  c: {type: gear, bodies: [frame, rod], at: [1, 2], line_of_action: x, "
                "tangent: x}\n",
                "E0314"},
        Mistake{"UnknownPassive", ", passive: [Tx]", "", "E0313"},
        Mistake{"ActuatorOfARigidCoupling",
                "",
                "  c: {type: rigid, bodies: [frame, rod]}\nactuators: {T: {coupling: c}}\n",
                "E0313"},
        Mistake{"ActuatorWithTheNameOfACoupling", "", "actuators: {a: {coupling: b}}\n", "E0307"},
        Mistake{"MotionInTheUnitOfALength", "", "cases: {one: {motion: {a.wz: 3 mm}}}\n", "E0309"},
        Mistake{
            "InputThatIsNoActuator", "", "cases: {one: {motion: {a.wz: 1}, input: a}}\n", "E0313"}),
    [](const auto& mistake) { return mistake.param.name; });

TEST(Bind, ReportsEveryMistakeOfAStageAtOnce) {
  const Bound bound(
      "kinestat: 1\nspace: planar\nground: frame\nbodies: [crank, rod]\ncouplings:\n"
      "  a: {type: revolute, bodies: [frame, krank], at: [0, 0]}\n"
      "  b: {type: revolute, bodies: [crank, rodd], at: [1, 1]}\n"
      "  c: {type: revolute, bodies: [rod, frame], at: [N9, 0]}\n");

  EXPECT_EQ(bound.codes(), Codes({"E0312", "E0312", "E0311"}));
}

TEST(Bind, WarnsOfAParameterThatNothingUses) {
  const Bound bound(chain("", "parameters: {N9: 4}\n"));

  EXPECT_TRUE(bound.mechanism);
  EXPECT_EQ(bound.codes(), Codes({"W0301"}));
}

}  // namespace
}  // namespace kinestat
