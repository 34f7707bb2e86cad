// What the mobility pass says of every mechanism of the library.

#include "studies/mobility/mobility.hpp"

#include <gtest/gtest.h>

#include "files/load_file.hpp"
#include "mechanism/bind/bind.hpp"
#include "property/identities.hpp"
#include "property/library_files.hpp"

namespace kinestat {
namespace {

class MobilityOf : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    SourceFile source;
    Diagnostics found;
    auto description = load_description((kLibraryFolder / GetParam()).string(), {}, source, found);
    ASSERT_TRUE(description.has_value());
    auto mechanism = bind(*description, found);
    auto in_space = bind_in_space(*description, found);
    ASSERT_TRUE(mechanism && in_space);
    mechanism_ = *std::move(mechanism);
    in_space_ = *std::move(in_space);
    exact_ = find_exact_mobility(mechanism_, in_space_);
  }

  Mechanism mechanism_;
  Mechanism in_space_;
  ExactMobility exact_;
};

INSTANTIATE_TEST_SUITE_P(File,
                         MobilityOf,
                         ::testing::ValuesIn(list_library_files()),
                         library_test_name);

// F_N - C_N = F - λ l, whatever the geometry.
TEST_P(MobilityOf, IsThatOfGrublerWithoutTheRedundantConstraints) {
  const MotionCounts& spatial = exact_.counts.spatial.motions;

  EXPECT_EQ(count_by_grubler(in_space_.topology, in_space_.topology, 6).mobility,
            spatial.net_freedom - spatial.net_constraint);
  if (exact_.counts.planar) {
    const MotionCounts& planar = exact_.counts.planar->motions;
    EXPECT_EQ(count_by_grubler(mechanism_.topology, in_space_.topology, 3).mobility,
              planar.net_freedom - planar.net_constraint);
  }
}

TEST_P(MobilityOf, HasAsManyMotionsAsNetFreedoms) {
  EXPECT_EQ(static_cast<int>(exact_.motions.motions.size()),
            exact_.counts.minimal.motions.net_freedom);
}

// Each keeps every coupling to its freedoms: t_head - t_tail = Σ φ $.
TEST_P(MobilityOf, HasMotionsThatTheCouplingsAllow) {
  for (const FreeMotion& motion : exact_.motions.motions) {
    double largest = 0.0;
    for (const Twist& twist : motion.bodies) {
      largest = std::max(largest, twist.coordinates().cwiseAbs().maxCoeff());
    }
    for (const CouplingTopology& coupling : mechanism_.topology.couplings) {
      Vec6 rest = motion.bodies[static_cast<std::size_t>(coupling.head.value)].coordinates() -
                  motion.bodies[static_cast<std::size_t>(coupling.tail.value)].coordinates();
      for (int f = coupling.first_freedom; f < coupling.first_freedom + coupling.freedom_count;
           ++f) {
        rest -= motion.rates[f] *
                mechanism_.geometry.motions[static_cast<std::size_t>(f)].coordinates();
      }
      EXPECT_LE(rest.cwiseAbs().maxCoeff(), 1e-9 * largest) << coupling.name;
    }
  }
}

void expect_listed(const Redundancies& redundancies, bool is_complete) {
  EXPECT_EQ(static_cast<int>(redundancies.constraints.size()), redundancies.borne);
  EXPECT_LE(redundancies.borne, redundancies.net_constraint);
  if (is_complete) {
    EXPECT_EQ(redundancies.borne, redundancies.net_constraint);
  }
}

// Couplings that bear all that they prevent are excused by the same identity as their counts.
TEST_P(MobilityOf, ListsEveryRedundantConstraint) {
  expect_listed(exact_.spatial, couplings_are_complementary(in_space_, 6));
  expect_listed(exact_.minimal, false);
  if (exact_.planar) {
    expect_listed(*exact_.planar, couplings_are_complementary(mechanism_, 3));
  }
}

TEST_P(MobilityOf, HasSelfStressesInEquilibrium) {
  for (const RedundantConstraint& one : exact_.spatial.constraints) {
    std::vector<Vec6> sums(in_space_.topology.bodies.size(), Vec6::Zero());
    double largest = 0.0;
    for (std::size_t e = 0; e < one.wrenches.size(); ++e) {
      const CouplingTopology& coupling = in_space_.topology.couplings[e];
      const Vec6 wrench = one.wrenches[e].coordinates();
      largest = std::max(largest, wrench.cwiseAbs().maxCoeff());
      sums[static_cast<std::size_t>(coupling.head.value)] += wrench;
      sums[static_cast<std::size_t>(coupling.tail.value)] -= wrench;
    }
    for (const Vec6& sum : sums) {
      EXPECT_LE(sum.cwiseAbs().maxCoeff(), 1e-9 * largest);
    }
  }
}

// With advice wherever something is redundant, and none that was not found to hold.
TEST_P(MobilityOf, HasVerifiedAdviceForWhatIsRedundant) {
  EXPECT_EQ(exact_.repairs.empty(), exact_.spatial.borne == 0);
  for (const Repair& repair : exact_.repairs) {
    EXPECT_TRUE(repair.is_verified);
    EXPECT_EQ(repair.freed, exact_.spatial.borne);
    EXPECT_EQ(repair.after.net_freedom, exact_.counts.spatial.motions.net_freedom);
  }
}

}  // namespace
}  // namespace kinestat
