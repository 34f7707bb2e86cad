#include "studies/mobility/grubler.hpp"

#include "mobility_case.hpp"

namespace kinestat {
namespace {

// A file without dimensions: bodies are b0 (the ground), b1, …; P_V are hinges, P_I cables.
std::string topology(int bodies,
                     const std::vector<std::pair<int, int>>& cables,
                     const std::vector<std::pair<int, int>>& hinges) {
  std::string text = "ground: b0\nbodies: [";
  for (int i = 1; i < bodies; ++i) {
    text += (i == 1 ? "b" : ", b") + std::to_string(i);
  }
  text += "]\ncouplings:\n";
  int number = 0;
  const auto add = [&](const char* type, std::pair<int, int> ends) {
    text += "  c" + std::to_string(++number) + ": {type: " + type + ", bodies: [b" +
            std::to_string(ends.first) + ", b" + std::to_string(ends.second) + "]}\n";
  };
  for (const auto& ends : cables) {
    add("cable", ends);
  }
  for (const auto& ends : hinges) {
    add("revolute", ends);
  }
  return text;
}

GrublerCount count_in_space(const MobilityCase& one) {
  return count_by_grubler(one.in_space.topology, one.in_space.topology, 6);
}

TEST(Grubler, CountsAPulleyWithTwoBlocks) {
  // Alves 2023, table 3.1 and eq. 3.1: M = 6 (4 - 1 - 5) + 13 = 1.
  const MobilityCase one = case_of_text(topology(4, {{2, 1}, {2, 3}}, {{1, 0}, {3, 0}, {2, 0}}));

  const GrublerCount count = count_in_space(one);

  EXPECT_EQ(count.freedoms, 13);
  EXPECT_EQ(count.mobility, 1);
  EXPECT_EQ(one.mechanism.graph.circuit_count(), 2);
}

TEST(Grubler, CountsTheSlipOfARopeOnAPulley) {
  // Table 3.2 and eq. 3.2: M = 6 (5 - 1 - 6) + 14 = 2.
  const MobilityCase one =
      case_of_text(topology(5, {{4, 1}, {4, 3}}, {{1, 0}, {3, 0}, {2, 0}, {4, 2}}));

  EXPECT_EQ(count_in_space(one).mobility, 2);
}

TEST(Grubler, CountsADeviceForTheRehabilitationOfFingers) {
  // Table 3.5 and eq. 3.6: M = 6 (9 - 1 - 12) + 28 = 4, four circuits.
  const MobilityCase one =
      case_of_text(topology(9,
                            {{7, 2}, {2, 3}, {3, 6}, {6, 8}},
                            {{0, 7}, {2, 1}, {1, 0}, {4, 0}, {3, 4}, {6, 5}, {5, 0}, {8, 0}}));

  EXPECT_EQ(count_in_space(one).mobility, 4);
  EXPECT_EQ(one.mechanism.graph.circuit_count(), 4);
}

TEST(Grubler, CountsInThePlane) {
  // Table 3.8 and eq. 3.8: the cables of table 3.2 as chains of two hinges: M = 3 (7 - 1 - 8) + 8.
  const MobilityCase one = case_of_text(
      "space: planar\n" +
      topology(7, {}, {{1, 0}, {3, 0}, {1, 5}, {3, 6}, {5, 4}, {6, 4}, {0, 2}, {2, 4}}));

  const GrublerCount count = count_by_grubler(one.mechanism.topology, one.in_space.topology, 3);

  EXPECT_EQ(count.mobility, 2);
  EXPECT_EQ(count.classes[5].couplings.size(), 8U);
}

TEST(Grubler, CountsTheSurgicalInstrument) {
  // Tables 3.6 and 3.7, eq. 3.7; 12 circuits, where the source prints 14.
  const MobilityCase one = case_of_library("cables/surgical_instrument");

  const GrublerCount count = count_in_space(one);

  EXPECT_EQ(count.bodies, 26);
  EXPECT_EQ(count.couplings, 37);
  EXPECT_EQ(count.classes[1].couplings.size(), 12U);
  EXPECT_EQ(count.classes[1].freedoms, 60);
  EXPECT_EQ(count.classes[5].couplings.size(), 25U);
  EXPECT_EQ(count.classes[5].freedoms, 25);
  EXPECT_EQ(count.mobility, 13);
  EXPECT_EQ(one.mechanism.graph.circuit_count(), 12);
}

TEST(Grubler, CallsAPlanarRopeOfTheFirstClass) {
  const MobilityCase one = case_of_text(
      "space: planar\nground: f\nbodies: [b]\ncouplings:\n"
      "  r: {type: cable, bodies: [f, b], from: [0, 0], to: [1, 0]}\n");

  const GrublerCount count = count_by_grubler(one.mechanism.topology, one.in_space.topology, 3);

  EXPECT_EQ(count.classes[1].couplings.size(), 1U);
  EXPECT_EQ(count.classes[1].freedoms, 2);
}

}  // namespace
}  // namespace kinestat
