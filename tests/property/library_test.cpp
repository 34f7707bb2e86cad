#include <gtest/gtest.h>

#include "files/load_file.hpp"
#include "property/identities.hpp"
#include "property/library_files.hpp"

namespace kinestat {
namespace {

class LibraryMechanism : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    SourceFile source;
    Diagnostics found;
    std::optional<Loaded> loaded = load((kLibraryFolder / GetParam()).string(), {}, source, found);
    for (const Diagnostic& item : found.items()) {
      if (item.code == "W0305") {
        continue;  // a planet with profile shift, as in the hybrid transaxle
      }
      ADD_FAILURE() << item.code << " in line " << item.where.line << ": " << item.message;
    }
    ASSERT_TRUE(loaded.has_value());
    couplings_ = std::move(loaded->description.couplings);
    network_.emplace(make_network_case(std::move(loaded->mechanism)));
  }

  std::vector<CouplingDescription> couplings_;
  std::optional<NetworkCase> network_;
};

INSTANTIATE_TEST_SUITE_P(File,
                         LibraryMechanism,
                         ::testing::ValuesIn(list_library_files()),
                         library_test_name);

TEST_P(LibraryMechanism, HasCircuitsOrthogonalToCutsets) {
  expect_orthogonal_graph(network_->mechanism.graph);
}

TEST_P(LibraryMechanism, HasTheSameRanksAsNodeSystemAndAsTextbookMatrices) {
  expect_equal_ranks(*network_);
}

// Teeth that roll, clutches, brakes and screws listed on both sides have no f + c = λ, nor has any
// coupling with `passive:`.
bool may_be_excused(const CouplingDescription& coupling) {
  using enum CouplingType;
  switch (coupling.type) {
    case gear:
    case bevel_gear:
    case worm:
    case rack:
    case clutch:
    case brake:
    case screws:
      return true;
    default:
      return coupling.passive.has_value();
  }
}

TEST_P(LibraryMechanism, OfComplementaryCouplingsHasTheSameCountsFromBothSides) {
  if (!couplings_are_complementary(network_->mechanism, network_->order())) {
    EXPECT_TRUE(std::ranges::any_of(couplings_, may_be_excused));
    return;
  }
  expect_complementary_counts(*network_);
}

TEST_P(LibraryMechanism, HasMotionsThatSatisfyTheCircuitLaw) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    SCOPED_TRACE(seed);
    Random random(seed);
    expect_solved_motions(*network_, choose_motions(*network_, random));
  }
}

TEST_P(LibraryMechanism, HasActionsThatSatisfyTheCutsetLaw) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    SCOPED_TRACE(seed);
    Random random(seed);
    expect_solved_actions(*network_, choose_actions(*network_, random));
  }
}

TEST_P(LibraryMechanism, NeitherGainsNorLosesPower) {
  Random random(1);
  const VecX rates = expect_solved_motions(*network_, choose_motions(*network_, random));
  const VecX magnitudes = expect_solved_actions(*network_, choose_actions(*network_, random));

  expect_balanced_power(*network_, rates, magnitudes);
}

// The cases of the file rest on the same identities as random primaries.
TEST_P(LibraryMechanism, HasCasesThatSatisfyTheLaws) {
  for (const Case& which : network_->mechanism.cases) {
    SCOPED_TRACE(which.label);
    if (!which.motions.empty() &&
        solve_velocity(network_->mechanism, network_->twist_basis, which.motions).status ==
            SolveStatus::solved) {
      expect_solved_motions(*network_, which.motions);
    }
    if (!which.actions.empty() &&
        solve_action(network_->mechanism, network_->wrench_basis, which.actions).status ==
            SolveStatus::solved) {
      expect_solved_actions(*network_, which.actions);
    }
  }
}

TEST_P(LibraryMechanism, HasCouplingsThatDoNoWork) {
  expect_reciprocal_couplings(*network_);
}

TEST_P(LibraryMechanism, MovesAlikeInTheMinimalOrder) {
  Random random(1);
  expect_motions_in_minimal_order(*network_, choose_motions(*network_, random));
}

TEST(Library, HoldsTheMechanismsThatItsFolderNames) {
  const std::vector<std::string> files = list_library_files();

  EXPECT_GE(files.size(), 2U);
  EXPECT_TRUE(std::ranges::binary_search(files, "planar/four_bar.yaml"));
  EXPECT_TRUE(std::ranges::binary_search(files, "transmissions/ravigneaux.yaml"));
}

}  // namespace
}  // namespace kinestat
