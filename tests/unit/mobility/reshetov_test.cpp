#include "studies/mobility/reshetov.hpp"

#include "mobility_case.hpp"

namespace kinestat {
namespace {

using Missing = std::vector<std::string>;

Missing missing_of(const ReshetovCircuit& circuit) {
  Missing missing;
  for (std::size_t i = 0; i < kClosures.size(); ++i) {
    if (!circuit.covered_by[i]) {
      missing.emplace_back(kClosures[i]);
    }
  }
  return missing;
}

ReshetovTable table_of(const std::string& name) {
  return find_reshetov_table(case_of_library(name).in_space);
}

// Alves 2023, section 2.2 by its own rules; the page counts two redundant constraints.
TEST(Reshetov, FindsThreeConstraintsRedundantInAPlanarFourBar) {
  const ReshetovTable table = table_of("planar/four_bar");

  ASSERT_EQ(table.circuits.size(), 1U);
  EXPECT_EQ(table.circuits[0].offered, (std::array<int, 6>{0, 0, 4, 0, 0, 0}));
  EXPECT_EQ(missing_of(table.circuits[0]), (Missing{"Rx", "Ry", "Tz"}));
  EXPECT_EQ(table.redundant, 3);
  EXPECT_EQ(table.mobility, 1);
}

// Fig. 2.5: C, S, R, R.
TEST(Reshetov, FindsNothingRedundantInTheSelfAligningFourBar) {
  const ReshetovTable table = table_of("spatial/self_aligning_four_bar");

  EXPECT_EQ(table.circuits[0].offered, (std::array<int, 6>{1, 1, 4, 0, 0, 1}));
  EXPECT_EQ(table.redundant, 0);
  EXPECT_EQ(table.mobility, 1);
}

// Closed form: turning about z covers Rz and, for lack of Ty, one translation; Tx is offered.
TEST(Reshetov, CoversATranslationByItself) {
  const ReshetovTable table = table_of("planar/slider_crank");

  EXPECT_EQ(missing_of(table.circuits[0]), (Missing{"Rx", "Ry", "Tz"}));
  EXPECT_EQ(table.mobility, 1);
}

// Closed form: nothing turns about z.
TEST(Reshetov, NeverCoversAMissingRotation) {
  const ReshetovTable table = table_of("spatial/sarrus");

  EXPECT_EQ(missing_of(table.circuits[0]), Missing{"Rz"});
  EXPECT_EQ(table.redundant, 1);
  EXPECT_EQ(table.mobility, 1);
}

// Four freedoms cover four demands at most; the linkage moves all the same (Bennett 1903).
TEST(Reshetov, FailsForBennett) {
  const ReshetovTable table = table_of("spatial/bennett");

  EXPECT_EQ(table.redundant, 2);
  EXPECT_EQ(table.mobility, 0);
}

TEST(Reshetov, NeverShiftsAlongTheAxisOfARotation) {
  // Six hinges about z: Rz, Tx, Ty are all that they can cover.
  std::string text = "ground: f\nbodies: [a, b, c, d, e]\ncouplings:\n";
  const std::vector<std::string> bodies = {"f", "a", "b", "c", "d", "e", "f"};
  for (std::size_t i = 0; i < 6; ++i) {
    text += "  j" + std::to_string(i) + ": {type: revolute, bodies: [" + bodies[i] + ", " +
            bodies[i + 1] + "], at: [" + std::to_string(i * i) + ", " + std::to_string(i) +
            ", 0], axis: z}\n";
  }

  const ReshetovTable table = find_reshetov_table(case_of_text(text).in_space);

  EXPECT_EQ(missing_of(table.circuits[0]), (Missing{"Rx", "Ry", "Tz"}));
  EXPECT_EQ(table.mobility, 3);
}

TEST(Reshetov, LetsASharedFreedomServeOneCircuit) {
  // Two circuits of hinges about z share c: 7 freedoms for 2 x (Rz, Tx, Ty).
  const ReshetovTable table = table_of("planar/watt_six_bar");

  EXPECT_EQ(table.redundant, 6);
  EXPECT_EQ(table.mobility, 1);
}

}  // namespace
}  // namespace kinestat
