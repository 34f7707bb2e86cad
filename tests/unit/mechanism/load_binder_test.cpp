#include "mechanism/cases/load_binder.hpp"

#include <gtest/gtest.h>

#include "support/mechanism_text.hpp"
#include "support/near.hpp"
#include "unit/mechanism/checked_text.hpp"

namespace kinestat {
namespace {

TEST(LoadBinder, AcceptsForcesAndCouples) {
  EXPECT_EQ(complaints_about("loads:\n"
                             "  wind: {body: block, at: [0, 0, 1 m], force: [1, 2, 3 kN]}\n"
                             "  drag: {body: shaft, couple: [0, 0, T]}\n"),
            Complaints{});
}

TEST(LoadBinder, ReportsABodyThatIsNotDeclared) {
  EXPECT_EQ(complaints_about("loads: {wind: {body: blok, couple: [0, 0, 1]}}\n"),
            (Complaints{"30:22 E0312 load 'wind' acts on body 'blok', which is not declared"}));
}

TEST(LoadBinder, WantsLengthsForcesAndMoments) {
  EXPECT_EQ(complaints_about(
                "loads:\n"
                "  w: {body: block, at: [1 N, 0, 0], force: [0, 1 mm, 0], couple: [0, 0, 1 N]}\n"),
            (Complaints{"31:25 E0309 expected a length, found a force",
                        "31:48 E0309 expected a force, found a length",
                        "31:73 E0309 expected a moment, found a force"}));
}

TEST(LoadBinder, LooksAtTheLoadsOfCases) {
  EXPECT_EQ(complaints_of(
                check_of("kinestat: 1\n"
                         "space: planar\n"
                         "ground: frame\n"
                         "bodies: [crank]\n"
                         "couplings: {a: {type: revolute, bodies: [frame, crank], at: [0, 0]}}\n"
                         "cases: {one: {loads: {wind: {body: rod, couple: 3 mm}}}}\n")),
            (Complaints{"6:36 E0312 load 'wind' acts on body 'rod', which is not declared",
                        "6:49 E0309 expected a moment, found a length"}));
}

TEST(LoadBinder, WarnsOfALoadOnTheGround) {
  EXPECT_EQ(complaints_about("loads: {wind: {body: housing, couple: [0, 0, 1]}}\n"),
            (Complaints{"30:22 W0301 load 'wind' acts on the ground 'housing', where it changes "
                        "nothing"}));
}

// A lever of 2 m on a pin at the origin; lines from 7 on are the sections.
std::string lever(const std::string& body, const std::string& sections) {
  return "space: planar\nunits: {length: mm}\nground: base\nbodies: {lever: " + body +
         "}\ncouplings: {a: {type: revolute, bodies: [base, lever], at: [1000, 0]}}\n" + sections;
}

std::vector<std::string> names_of(const std::vector<Load>& loads) {
  std::vector<std::string> names;
  for (const Load& load : loads) {
    names.push_back(load.name);
  }
  return names;
}

using Names = std::vector<std::string>;

TEST(Load, IsAForceAtItsPointAndACoupleAboutZInThePlane) {
  const Mechanism mechanism = mechanism_of(
      lever("",
            "loads: {push: {body: lever, at: [2000, 3000], force: [5, -7], couple: 4}}\n"
            "cases: {one: {action: {}}}\n"));

  // T = p x F + C = 2 · (-7) - 3 · 5 + 4 = -25 N·m about the world origin.
  ASSERT_EQ(mechanism.cases.at(0).loads.size(), 1U);
  const Load& load = mechanism.cases[0].loads[0];
  EXPECT_EQ(load.acts.body, BodyId{1});
  EXPECT_TRUE(is_near(load.acts.wrench.force, Vec3(5.0, -7.0, 0.0), kTight));
  EXPECT_TRUE(is_near(load.acts.wrench.moment, Vec3(0.0, 0.0, -25.0), 1e-12));
  ASSERT_TRUE(load.point);
  EXPECT_TRUE(is_near(*load.point, Vec3(2.0, 3.0, 0.0), kTight));
  EXPECT_TRUE(is_near(couple_of(load), Vec3(0.0, 0.0, 4.0), 1e-12));
}

TEST(Load, OfACoupleAloneHasNoPoint) {
  const Mechanism mechanism = mechanism_of(
      "ground: base\nbodies: [arm]\n"
      "couplings: {a: {type: rigid, bodies: [base, arm], at: [1, 2, 3]}}\n"
      "loads: {twist: {body: arm, couple: [1, -2, 3]}}\n"
      "cases: {one: {action: {}}}\n");

  const Load& load = mechanism.cases.at(0).loads.at(0);
  EXPECT_FALSE(load.point);
  EXPECT_EQ(load.acts.wrench.force, Vec3(0.0, 0.0, 0.0));
  EXPECT_EQ(couple_of(load), Vec3(1.0, -2.0, 3.0));
}

TEST(Load, FarFromTheWorldOriginIsWrittenAboutThatOfTheGeometry) {
  const Mechanism mechanism = mechanism_of(
      "ground: base\nbodies: [arm]\n"
      "couplings: {a: {type: rigid, bodies: [base, arm], at: [1e9, 0, 0]}}\n"
      "loads: {push: {body: arm, at: [1e9 + 2, 0, 0], force: [0, 3, 0]}}\n"
      "cases: {one: {action: {}}}\n");

  // 2 m beside the only point, at which the geometry has its origin.
  const Load& load = mechanism.cases.at(0).loads.at(0);
  EXPECT_EQ(load.acts.wrench.moment, Vec3(0.0, 0.0, 6.0));
}

TEST(Load, OfACaseReplacesTheCommonOneOfItsName) {
  const Mechanism mechanism = mechanism_of(lever("{mass: 2, centre_of_mass: [500, 0]}",
                                                 "loads:\n"
                                                 "  first: {body: lever, couple: 1}\n"
                                                 "  second: {body: lever, couple: 2}\n"
                                                 "gravity: [0, -10 m/s^2]\n"
                                                 "cases:\n"
                                                 "  common: {action: {}}\n"
                                                 "  own: {loads: {third: {body: lever, couple: 3},"
                                                 " first: {body: lever, couple: 4}}}\n"));

  ASSERT_EQ(mechanism.cases.size(), 2U);
  EXPECT_EQ(names_of(mechanism.cases[0].loads), (Names{"first", "second", "gravity.lever"}));
  EXPECT_EQ(names_of(mechanism.cases[1].loads),
            (Names{"first", "second", "third", "gravity.lever"}));
  EXPECT_EQ(mechanism.cases[0].loads[0].acts.wrench.moment.z(), 1.0);
  EXPECT_EQ(mechanism.cases[1].loads[0].acts.wrench.moment.z(), 4.0);
}

TEST(Load, OnTheGroundIsNone) {
  const SourceFile source{.path = "test",
                          .text = "kinestat: 1\n" + lever("",
                                                          "loads: {push: {body: base, couple: 3}}\n"
                                                          "cases: {one: {motion: {a.wz: 1}}}\n")};
  Diagnostics found;
  const std::optional<YamlNode> tree = read_yaml(source, {}, found);

  const std::optional<Mechanism> mechanism = bind(*read_mechanism(*tree, found), found);

  ASSERT_TRUE(mechanism);
  EXPECT_TRUE(mechanism->cases.at(0).loads.empty());
  EXPECT_FALSE(mechanism->cases[0].asks_actions);
}

TEST(Load, AsksForTheActionsOfItsCase) {
  const Mechanism mechanism =
      mechanism_of(lever("",
                         "actuators: {motor: {coupling: a}}\n"
                         "cases:\n  idle: {motion: {motor: 1}}\n"
                         "  loaded: {motion: {motor: 1}, loads: {p: {body: lever, couple: 1}}}\n"));

  EXPECT_FALSE(mechanism.cases.at(0).asks_actions);
  EXPECT_TRUE(mechanism.cases.at(1).asks_actions);
}

}  // namespace
}  // namespace kinestat
