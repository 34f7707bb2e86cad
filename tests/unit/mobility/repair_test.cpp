#include "studies/mobility/repair.hpp"

#include <algorithm>

#include "couplings/kinds.hpp"
#include "mobility_case.hpp"

namespace kinestat {
namespace {

std::string words_of(const Mechanism& mechanism, const Repair& repair) {
  std::string words;
  for (const CouplingChange& change : repair.changes) {
    words += (words.empty() ? "" : ", ") + mechanism.topology.coupling(change.coupling).name + " " +
             (change.to ? std::string(word_of(*change.to))
                        : std::string(change.is_left_out ? "left out" : "freer"));
  }
  return words;
}

std::vector<std::string> words_of(const MobilityCase& one) {
  std::vector<std::string> words;
  for (const Repair& repair : one.exact().repairs) {
    words.push_back(words_of(one.in_space, repair));
  }
  return words;
}

const std::string kFourHinges =
    "ground: frame\nbodies: [crank, coupler, rocker]\ncouplings:\n"
    "  a: {type: revolute, bodies: [frame, crank], at: [0, 0, 0], axis: z}\n"
    "  b: {type: revolute, bodies: [crank, coupler], at: [1, 3, 0], axis: z}\n"
    "  c: {type: revolute, bodies: [coupler, rocker], at: [6, 5, 0], axis: z}\n"
    "  d: {type: revolute, bodies: [frame, rocker], at: [7, 0, 0], axis: z}\n";

// Alves 2023, Fig. 2.5 after Reshetov 1979: a becomes cylindrical, b spherical.
TEST(Repair, FindsReshetovsFourBarFirst) {
  EXPECT_EQ(words_of(case_of_text(kFourHinges)).at(0), "a cylindrical, b spherical");
}

TEST(Repair, LeavesActuatedCouplingsAlone) {
  const auto words =
      words_of(case_of_text(kFourHinges + "actuators: {m: {coupling: a}, w: {coupling: d}}\n"));

  EXPECT_EQ(words.at(0), "b cylindrical, c spherical");
}

TEST(Repair, KeepsTheMobility) {
  const MobilityCase one = case_of_text(kFourHinges);

  const std::vector<Repair> repairs = one.exact().repairs;

  ASSERT_FALSE(repairs.empty());
  for (const Repair& repair : repairs) {
    SCOPED_TRACE(words_of(one.in_space, repair));
    EXPECT_EQ(repair.freed, 3);
    EXPECT_EQ(repair.after.net_freedom, 1);
    EXPECT_EQ(repair.after.net_constraint, 0);
    EXPECT_TRUE(repair.is_verified);
  }
}

TEST(Repair, IsRefutedWhereItOnlyAddsMobility) {
  // With balls at both ends the coupler spins: four more freedoms, three redundancies less.
  const MobilityCase one = case_of_text(kFourHinges);
  const ExactMobility exact = one.exact();
  const auto ball = [](int coupling, const Vec3& at) {
    return CouplingChange{
        .coupling = {coupling},
        .to = CouplingType::spherical,
        .is_left_out = false,
        .added = {unit_rotation(Vec3::UnitX(), at), unit_rotation(Vec3::UnitY(), at)}};
  };

  const Repair repair = verify_repair(
      one.in_space, exact.counts.spatial.motions, {ball(1, {1, 3, 0}), ball(2, {6, 5, 0})});

  EXPECT_EQ(repair.after.net_freedom, 2);
  EXPECT_EQ(repair.after.net_constraint, 0);
  EXPECT_FALSE(repair.is_verified);
}

TEST(Repair, OfSarrusTurnsAnyHingeIntoAGimbalAboutTheMissingDirection) {
  const MobilityCase one = case_of_library("spatial/sarrus");

  for (const Repair& repair : one.exact().repairs) {
    ASSERT_EQ(repair.changes.size(), 1U);
    ASSERT_EQ(repair.changes[0].added.size(), 1U);
    EXPECT_EQ(repair.changes[0].added[0].angular, Vec3::UnitZ());
  }
}

// Any of the bars of a square with two diagonals may be left out.
TEST(Repair, LeavesABarOutThatBearsOneForce) {
  const auto words = words_of(case_of_library("planar/braced_frame"));

  ASSERT_FALSE(words.empty());
  EXPECT_TRUE(words[0].ends_with("left out"));
}

// One guide holds what two hold.
TEST(Repair, LeavesOneOfTwoParallelGuidesOut) {
  const MobilityCase one = case_of_text(
      "ground: frame\nbodies: [table]\ncouplings:\n"
      "  left: {type: prismatic, bodies: [frame, table], at: [0, 0, 0], axis: x}\n"
      "  right: {type: prismatic, bodies: [frame, table], at: [0, 1, 0], axis: x}\n");

  const std::vector<Repair> repairs = one.exact().repairs;

  ASSERT_EQ(words_of(one), (std::vector<std::string>{"left left out", "right left out"}));
  EXPECT_EQ(repairs[0].freed, 5);
  EXPECT_EQ(repairs[0].after.net_freedom, 1);
}

// A door on three hinges has ten constraints more than it needs: it hangs on a ball and a ball that
// slides in a tube (Reshetov 1979), and the third hinge goes.
TEST(Repair, HangsADoorOnTwoBalls) {
  const MobilityCase one = case_of_text(
      "ground: frame\nbodies: [door]\ncouplings:\n"
      "  low: {type: revolute, bodies: [frame, door], at: [0, 0, 0], axis: z}\n"
      "  middle: {type: revolute, bodies: [frame, door], at: [0, 0, 1], axis: z}\n"
      "  high: {type: revolute, bodies: [frame, door], at: [0, 0, 2], axis: z}\n");

  const std::vector<Repair> repairs = one.exact().repairs;

  ASSERT_FALSE(repairs.empty());
  EXPECT_EQ(words_of(one.in_space, repairs[0]),
            "low spherical, middle sphere_in_tube, high left out");
  for (const Repair& repair : repairs) {
    EXPECT_EQ(repair.freed, 10);
    EXPECT_EQ(repair.after.net_freedom, 1);
    EXPECT_EQ(repair.after.net_constraint, 0);
  }
}

// A driven guide is the one that stays.
TEST(Repair, KeepsTheGuideThatIsDriven) {
  const auto words = words_of(
      case_of_text("ground: frame\nbodies: [table]\ncouplings:\n"
                   "  left: {type: prismatic, bodies: [frame, table], at: [0, 0, 0], axis: x}\n"
                   "  right: {type: prismatic, bodies: [frame, table], at: [0, 1, 0], axis: x}\n"
                   "actuators: {drive: {coupling: left}}\n"));

  EXPECT_EQ(words, std::vector<std::string>{"right left out"});
}

TEST(Repair, IsNotNeededByTheSelfAligningFourBar) {
  EXPECT_TRUE(case_of_library("spatial/self_aligning_four_bar").exact().repairs.empty());
}

}  // namespace
}  // namespace kinestat
