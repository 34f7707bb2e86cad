#include "statics/indeterminacy.hpp"

#include <cmath>

#include <Eigen/LU>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "network/bases.hpp"
#include "statics/action.hpp"
#include "support/mechanism_text.hpp"
#include "support/near.hpp"
#include "support/random.hpp"
#include "unit/statics/magnitude.hpp"

namespace kinestat {
namespace {

// The first case of the mechanism, as the program solves it.
StaticSolution solve_as_chosen(const Mechanism& mechanism) {
  const Case& which = mechanism.cases.at(0);
  const std::vector<BodyWrench> loads = wrenches_of(which.loads);
  const CoordinateBasis basis = action_basis(mechanism.geometry, mechanism.static_order, loads);
  return resolve_indeterminacy(
      mechanism, basis, which.actions, loads, solve_action(mechanism, basis, which.actions, loads));
}

std::string statics(std::string_view choice) {
  return fmt::format("statics: {{indeterminate: {}}}\ncases: {{one: {{action: {{}}}}}}\n", choice);
}

// A rigid beam on supports at 0, 1 and 3 m that bear only upwards.
std::string beam(std::string_view k_a, std::string_view k_b, std::string_view k_c, double load_at) {
  const auto support = [](std::string_view name, int at, std::string_view stiffness) {
    return fmt::format(
        "  {}: {{type: revolute, bodies: [base, beam], at: [{}, 0], passive: [Ry]{}}}\n",
        name,
        at,
        stiffness.empty() ? "" : fmt::format(", stiffness: {{Ry: {}}}", stiffness));
  };
  return "space: planar\nground: base\nbodies: [beam]\ncouplings:\n" + support("a", 0, k_a) +
         support("b", 1, k_b) + support("c", 3, k_c) +
         fmt::format("loads: {{push: {{body: beam, at: [{}, 0], force: [0, -700]}}}}\n", load_at);
}

TEST(Stiffness, SharesALoadAtTheCentreOfStiffnessInProportion) {
  const Mechanism mechanism =
      mechanism_of(beam("1e6 N/m", "2e6 N/m", "4e6 N/m", 2.0) + statics("stiffness"));

  const StaticSolution solution = solve_as_chosen(mechanism);

  // The centre Σkx/Σk = (2 + 12)/7 = 2 m: the beam does not tilt, and each bears k/Σk of 700 N.
  EXPECT_EQ(solution.status, SolveStatus::solved);
  EXPECT_NEAR(magnitude(mechanism, solution, "a.Ry"), 100.0, 1e-10);
  EXPECT_NEAR(magnitude(mechanism, solution, "b.Ry"), 200.0, 1e-10);
  EXPECT_NEAR(magnitude(mechanism, solution, "c.Ry"), 400.0, 1e-10);
}

TEST(Stiffness, SharesALoadBesideTheCentreWithTheTiltOfTheBeam) {
  const Mechanism mechanism =
      mechanism_of(beam("1e6 N/m", "2e6 N/m", "4e6 N/m", 1.0) + statics("stiffness"));

  const StaticSolution solution = solve_as_chosen(mechanism);

  // Sinking by α + β x: Σk α + Σkx β = 700 and Σkx α + Σkx² β = 700 · 1, so that α = 0.24 mm and
  // β = -0.07 mm/m, and the supports bear k (α + β x).
  ASSERT_EQ(solution.status, SolveStatus::solved);
  EXPECT_NEAR(magnitude(mechanism, solution, "a.Ry"), 240.0, 1e-10);
  EXPECT_NEAR(magnitude(mechanism, solution, "b.Ry"), 340.0, 1e-10);
  EXPECT_NEAR(magnitude(mechanism, solution, "c.Ry"), 120.0, 1e-10);
  EXPECT_EQ(solution.completion.by, IndeterminateChoice::stiffness);
  EXPECT_EQ(solution.completion.actions, (std::vector<int>{0, 1, 2}));
  EXPECT_LE(solution.residual, 1e-14);
}

TEST(Stiffness, OfOneSupportAmongRigidOnesBearsNothing) {
  const Mechanism mechanism = mechanism_of(beam("", "2e6 N/m", "", 1.0) + statics("stiffness"));

  const StaticSolution solution = solve_as_chosen(mechanism);

  // The rigid supports keep the beam in place, so that the elastic one is not pressed.
  ASSERT_EQ(solution.status, SolveStatus::solved);
  EXPECT_NEAR(magnitude(mechanism, solution, "a.Ry"), 700.0 * 2.0 / 3.0, 1e-10);
  EXPECT_EQ(magnitude(mechanism, solution, "b.Ry"), 0.0);
  EXPECT_NEAR(magnitude(mechanism, solution, "c.Ry"), 700.0 / 3.0, 1e-10);
}

TEST(Stiffness, SpansNineteenDecades) {
  const Mechanism mechanism =
      mechanism_of(beam("1e-4 N/m", "2e-4 N/m", "1e15 N/m", 1.0) + statics("stiffness"));

  const StaticSolution solution = solve_as_chosen(mechanism);

  // As if the third were rigid: the beam turns about it by β, the others at 3 m and 2 m from it:
  // (9 k_a + 4 k_b) β = 700 · 2, F = k · distance · β.
  const double beta = 1400.0 / (9.0 * 1.0 + 4.0 * 2.0);
  ASSERT_EQ(solution.status, SolveStatus::solved);
  EXPECT_NEAR(magnitude(mechanism, solution, "a.Ry"), 3.0 * beta, 1e-9);
  EXPECT_NEAR(magnitude(mechanism, solution, "b.Ry"), 2.0 * 2.0 * beta, 1e-9);
}

// A shaft between two fixed bearings, which bear along it as well.
const std::string kShaft =
    "ground: base\nbodies: [shaft]\ncouplings:\n"
    "  a: {type: revolute, bodies: [base, shaft], at: [0, 0, 0], axis: x, passive: [Rx, Ry, Rz]";
const std::string kShaftEnd =
    "}\n  b: {type: revolute, bodies: [base, shaft], at: [2, 0, 0], axis: x, passive: [Rx, Ry, Rz]";

TEST(Stiffness, SharesTheThrustOfAShaftBetweenItsBearings) {
  const Mechanism mechanism = mechanism_of(
      kShaft + ", stiffness: {Rx: 3e7}" + kShaftEnd +
      ", stiffness: {Rx: 1e7}}\nloads: {push: {body: shaft, at: [0.5, 0, 0], force: [8, 4, 0]}}\n" +
      statics("stiffness"));

  const StaticSolution solution = solve_as_chosen(mechanism);

  ASSERT_EQ(solution.status, SolveStatus::solved);
  EXPECT_NEAR(magnitude(mechanism, solution, "a.Rx"), -6.0, 1e-13);
  EXPECT_NEAR(magnitude(mechanism, solution, "b.Rx"), -2.0, 1e-13);
  EXPECT_NEAR(magnitude(mechanism, solution, "a.Ry"), -3.0, 1e-13);
  EXPECT_EQ(solution.completion.actions.size(), 2U);
}

TEST(Stiffness, LeavesOpenWhatRigidActionsLeaveOpen) {
  const Mechanism mechanism = mechanism_of(
      "space: planar\nground: base\nbodies: [beam]\ncouplings:\n"
      "  a: {type: revolute, bodies: [base, beam], at: [0, 0], stiffness: {Ry: 1e6}}\n"
      "  b: {type: revolute, bodies: [base, beam], at: [1, 0], stiffness: {Ry: 2e6}}\n"
      "  c: {type: revolute, bodies: [base, beam], at: [3, 0], stiffness: {Ry: 4e6}, "
      "passive: [Ry]}\n"
      "loads: {push: {body: beam, at: [2, 0], force: [9, -700]}}\n" +
      statics("stiffness"));

  const StaticSolution solution = solve_as_chosen(mechanism);

  EXPECT_EQ(solution.status, SolveStatus::underdetermined);
  EXPECT_NEAR(magnitude(mechanism, solution, "b.Ry"), 200.0, 1e-10);
  EXPECT_TRUE(std::isnan(magnitude(mechanism, solution, "a.Rx")));
  EXPECT_TRUE(std::isnan(magnitude(mechanism, solution, "b.Rx")));
  EXPECT_FALSE(solution.wrenches.at(0).has_value());
  EXPECT_TRUE(solution.wrenches.at(2).has_value());
}

TEST(Stiffness, LeavesASelfStressOutThatNoLoadCauses) {
  const Mechanism mechanism = mechanism_of(kShaft + ", stiffness: {Rx: 3e7}" + kShaftEnd +
                                           ", stiffness: {Rx: 1e7}}\n" + statics("stiffness"));

  const StaticSolution solution = solve_as_chosen(mechanism);

  EXPECT_EQ(magnitude(mechanism, solution, "a.Rx"), 0.0);
  EXPECT_EQ(magnitude(mechanism, solution, "b.Rx"), 0.0);
}

TEST(Stiffness, MeetsAKnownPreload) {
  Mechanism mechanism = mechanism_of(
      kShaft + ", stiffness: {Rx: 3e7}" + kShaftEnd +
      ", stiffness: {Rx: 1e7}}\nloads: {push: {body: shaft, at: [0.5, 0, 0], force: [8, 4, 0]}}\n" +
      statics("stiffness"));
  mechanism.cases[0].actions = {known_action(mechanism, "b.Rx", -5.0)};

  const StaticSolution solution = solve_as_chosen(mechanism);

  EXPECT_EQ(solution.status, SolveStatus::solved);
  EXPECT_NEAR(magnitude(mechanism, solution, "a.Rx"), -3.0, 1e-13);
  EXPECT_TRUE(solution.completion.actions.empty());
}

TEST(MinimumNorm, HalvesALoadBetweenTwoAlike) {
  const Mechanism mechanism = mechanism_of(
      kShaft + kShaftEnd + "}\nloads: {push: {body: shaft, at: [0.5, 0, 0], force: [8, 4, 0]}}\n" +
      statics("minimum_norm"));

  const StaticSolution solution = solve_as_chosen(mechanism);

  EXPECT_EQ(solution.status, SolveStatus::underdetermined);
  EXPECT_EQ(solution.completion.by, IndeterminateChoice::minimum_norm);
  EXPECT_NEAR(magnitude(mechanism, solution, "a.Rx"), -4.0, 1e-14);
  EXPECT_NEAR(magnitude(mechanism, solution, "b.Rx"), -4.0, 1e-14);
  EXPECT_TRUE(is_by_convention(solution, action_index(mechanism, "a.Rx")));
  EXPECT_FALSE(is_by_convention(solution, action_index(mechanism, "a.Ry")));
  EXPECT_TRUE(is_by_convention(solution, mechanism.topology.couplings[0]));
}

TEST(MinimumNorm, DividesCouplesByTheLengthOfTheMechanism) {
  const Mechanism mechanism = mechanism_of(
      "space: planar\nground: base\nbodies: [block]\ncouplings:\n"
      "  a: {type: prismatic, bodies: [base, block], at: [0, 0], axis: x}\n"
      "  b: {type: prismatic, bodies: [base, block], at: [4, 0], axis: x}\n"
      "loads: {push: {body: block, at: [4, 0], force: [0, -8]}}\n" +
      statics("minimum_norm"));

  const StaticSolution solution = solve_as_chosen(mechanism);

  // The least R1² + R2² + (T1² + T2²)/4² with R1 + R2 = 8 and 4 R2 + T1 + T2 = 32: by Lagrange
  // R = 4 ∓ μ, T = 8 μ with 20 μ = 16.
  EXPECT_EQ(solution.completion.length, 4.0);
  EXPECT_NEAR(magnitude(mechanism, solution, "a.Ry"), 3.2, 1e-13);
  EXPECT_NEAR(magnitude(mechanism, solution, "b.Ry"), 4.8, 1e-13);
  EXPECT_NEAR(magnitude(mechanism, solution, "a.Tz"), 6.4, 1e-13);
  EXPECT_NEAR(magnitude(mechanism, solution, "b.Tz"), 6.4, 1e-13);
}

TEST(Report, GivesNoValuesButTheSelfStress) {
  const Mechanism mechanism = mechanism_of(kShaft + kShaftEnd + "}\n" + statics("report"));

  const StaticSolution solution = solve_as_chosen(mechanism);

  EXPECT_EQ(solution.status, SolveStatus::underdetermined);
  EXPECT_TRUE(solution.completion.actions.empty());
  EXPECT_TRUE(std::isnan(magnitude(mechanism, solution, "a.Rx")));
  ASSERT_EQ(solution.self_stresses.size(), 1U);
  const std::vector<DependenceTerm>& terms = solution.self_stresses[0].terms;
  ASSERT_EQ(terms.size(), 2U);
  EXPECT_EQ(terms[0].index, action_index(mechanism, "a.Rx"));
  EXPECT_EQ(terms[0].coefficient, 1.0);
  EXPECT_EQ(terms[1].index, action_index(mechanism, "b.Rx"));
  EXPECT_NEAR(terms[1].coefficient, -1.0, 1e-14);
}

// A pin-jointed truss: joints are bodies, bars are couplings that bear along their line only.
struct Truss {
  int free_count = 0;
  std::vector<Eigen::Vector2d> joints;  ///< the free ones first, then those of the ground

  struct Bar {
    int from = 0;
    int to = 0;
    double stiffness = 1.0;  ///< E A / l [N/m]
  };

  std::vector<Bar> bars;
  std::vector<Eigen::Vector2d> forces;  ///< on the free joints [N]
};

Truss make_truss(std::uint64_t seed) {
  Random random(seed);
  Truss truss;
  truss.free_count = random.whole(1, 6);
  for (int i = 0; i < truss.free_count + 3; ++i) {
    truss.joints.emplace_back(random.between(-1.0, 1.0) + i, random.between(-1.0, 1.0));
  }
  // Each free joint on two others or the ground, and some bars more.
  for (int i = 0; i < truss.free_count; ++i) {
    truss.bars.push_back({i, truss.free_count, std::pow(10.0, random.between(4.0, 8.0))});
    truss.bars.push_back({i, truss.free_count + 1, std::pow(10.0, random.between(4.0, 8.0))});
    truss.forces.emplace_back(random.magnitude(), random.magnitude());
  }
  for (int i = 0; i < truss.free_count + 1; ++i) {
    const int from = random.whole(0, truss.free_count - 1);
    const int to = (from + random.whole(1, truss.free_count + 2)) % (truss.free_count + 3);
    truss.bars.push_back({from, to, std::pow(10.0, random.between(4.0, 8.0))});
  }
  return truss;
}

std::string text_of(const Truss& truss) {
  const auto joint = [&](int i) { return i < truss.free_count ? fmt::format("j{}", i) : "wall"; };
  const auto point = [](const Eigen::Vector2d& p) {
    return fmt::format("[{:.17g}, {:.17g}]", p.x(), p.y());
  };
  std::string text = "space: planar\nground: wall\nbodies:\n";
  for (int i = 0; i < truss.free_count; ++i) {
    text += fmt::format("  j{}:\n", i);
  }
  text += "couplings:\n";
  for (std::size_t b = 0; b < truss.bars.size(); ++b) {
    const Truss::Bar& bar = truss.bars[b];
    text += fmt::format(
        "  b{}: {{type: cable, bodies: [{}, {}], from: {}, to: {}, stiffness: {{F: {:.17g}}}}}\n",
        b,
        joint(bar.from),
        joint(bar.to),
        point(truss.joints[static_cast<std::size_t>(bar.from)]),
        point(truss.joints[static_cast<std::size_t>(bar.to)]),
        bar.stiffness);
  }
  text += "loads:\n";
  for (std::size_t i = 0; i < truss.forces.size(); ++i) {
    text += fmt::format("  p{}: {{body: j{}, at: {}, force: {}}}\n",
                        i,
                        i,
                        point(truss.joints[i]),
                        point(truss.forces[i]));
  }
  return text + statics("stiffness");
}

// The stiffness method: the displacements of the joints from K u = P, the tension of each bar from
// how much it is stretched.
VecX tensions_of(const Truss& truss) {
  const Eigen::Index n = 2 * truss.free_count;
  MatX K = MatX::Zero(n, n);
  VecX P(n);
  std::vector<VecX> stretches;
  for (const Truss::Bar& bar : truss.bars) {
    const Eigen::Vector2d line = (truss.joints[static_cast<std::size_t>(bar.to)] -
                                  truss.joints[static_cast<std::size_t>(bar.from)])
                                     .normalized();
    VecX stretch = VecX::Zero(n);
    if (bar.from < truss.free_count) {
      stretch.segment<2>(2 * bar.from) -= line;
    }
    if (bar.to < truss.free_count) {
      stretch.segment<2>(2 * bar.to) += line;
    }
    K += bar.stiffness * stretch * stretch.transpose();
    stretches.push_back(stretch);
  }
  for (int i = 0; i < truss.free_count; ++i) {
    P.segment<2>(2 * i) = truss.forces[static_cast<std::size_t>(i)];
  }
  const VecX u = K.fullPivLu().solve(P);
  VecX tensions(static_cast<Eigen::Index>(truss.bars.size()));
  for (Eigen::Index b = 0; b < tensions.size(); ++b) {
    const auto i = static_cast<std::size_t>(b);
    tensions[b] = truss.bars[i].stiffness * stretches[i].dot(u);
  }
  return tensions;
}

class Trusses : public ::testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Seed, Trusses, ::testing::Range(0, 40));

TEST_P(Trusses, BearWhatTheStiffnessMethodSays) {
  const Truss truss = make_truss(static_cast<std::uint64_t>(GetParam()));
  SCOPED_TRACE(text_of(truss));
  const Mechanism mechanism = mechanism_of(text_of(truss));

  const StaticSolution solution = solve_as_chosen(mechanism);

  ASSERT_EQ(solution.status, SolveStatus::solved);
  EXPECT_GT(solution.check.missing, 0);
  const VecX expected = tensions_of(truss);
  VecX tensions(expected.size());
  for (Eigen::Index b = 0; b < tensions.size(); ++b) {
    tensions[b] = magnitude(mechanism, solution, fmt::format("b{}.F", b));
  }
  EXPECT_TRUE(is_near(tensions, expected, 1e-9 * expected.cwiseAbs().maxCoeff()));
}

}  // namespace
}  // namespace kinestat
