#include "network/network_matrices.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "files/load_file.hpp"
#include "math/elimination/rank.hpp"
#include "support/mechanism_text.hpp"
#include "support/near.hpp"

namespace kinestat {
namespace {

Mechanism ravigneaux() {
  SourceFile source;
  Diagnostics found;
  std::optional<Loaded> loaded =
      load(KINESTAT_SOURCE_DIR "/mechanisms/transmissions/ravigneaux.yaml", {}, source, found);
  EXPECT_TRUE(loaded.has_value());
  return loaded ? std::move(loaded->mechanism) : Mechanism{};
}

// wz and vx: all points lie in the plane x = 0.
LabelledMatrix ravigneaux_motions() {
  const Mechanism mechanism = ravigneaux();
  Mat6X screws(6, mechanism.topology.freedom_count());
  for (int f = 0; f < mechanism.topology.freedom_count(); ++f) {
    screws.col(f) = mechanism.geometry.motions[static_cast<std::size_t>(f)].coordinates();
  }
  const CoordinateBasis basis =
      find_minimal_basis(screws, ScrewKind::twist, mechanism.geometry.length);
  return motion_matrices(mechanism.topology, mechanism.geometry, mechanism.graph, basis).back();
}

LabelledMatrix ravigneaux_actions() {
  const Mechanism mechanism = ravigneaux();
  return action_matrices(mechanism.topology,
                         mechanism.geometry,
                         mechanism.graph,
                         spatial_basis(ScrewKind::wrench, 1.0))
      .back();
}

// The row of a matrix by the name of each column's coupling, in the order a to k.
VecX row_of(const LabelledMatrix& matrix, const std::string& name) {
  const auto row = std::ranges::find(matrix.rows, name);
  EXPECT_NE(row, matrix.rows.end()) << name;
  VecX result(matrix.value.cols());
  for (std::size_t c = 0; c < matrix.columns.size(); ++c) {
    result[matrix.columns[c][0] - 'a'] =
        matrix.value(row - matrix.rows.begin(), static_cast<Eigen::Index>(c));
  }
  return result;
}

TEST(MotionNetwork, OfTheRavigneauxTrainIsTenByElevenOfRankNine) {
  // Cazangi 2008, Eqs. 5.39 and 5.40.
  const LabelledMatrix M_N = ravigneaux_motions();

  EXPECT_EQ(M_N.value.rows(), 10);
  EXPECT_EQ(M_N.value.cols(), 11);
  EXPECT_EQ(find_rank(M_N.value).rank, 9);
}

TEST(ActionNetwork, OfTheRavigneauxTrainIs36By39OfRank36) {
  // Cazangi 2008, Eq. 5.41.
  const LabelledMatrix A_N = ravigneaux_actions();

  EXPECT_EQ(A_N.value.rows(), 36);
  EXPECT_EQ(A_N.value.cols(), 39);
  EXPECT_EQ(find_rank(A_N.value).rank, 36);
}

// In circuit d all bearings lie on the main axis; "the second line is zero" (Cazangi 2008, below
// Eq. 5.39).
TEST(MotionNetwork, OfTheRavigneauxTrainHasAZeroRowForCircuitD) {
  EXPECT_TRUE(is_near(row_of(ravigneaux_motions(), "d.vx"), VecX::Zero(11), 0.0));
}

// Rows wz are the circuits of Eq. 5.10, because all axes are z.
TEST(MotionNetwork, OfTheRavigneauxTrainHasTheCircuitsInItsRotations) {
  const VecX expected = (VecX(11) << 1, 0, 0, 0, -1, -1, 0, 1, 0, 0, 0).finished();

  EXPECT_TRUE(is_near(row_of(ravigneaux_motions(), "h.wz"), expected, 0.0));
}

// Rows vx are the circuits times y of each axis: f_y = 17, g_y = 63/2, i_y = 49/2 (Cazangi 2008,
// Tab. 5.8 with the teeth of the train).
TEST(MotionNetwork, OfTheRavigneauxTrainHasTheHeightsOfTheAxesInItsTranslations) {
  const VecX expected = (VecX(11) << 0, 0, 0, 0, 0, 17.0, -31.5, 0, 24.5, 0, 0).finished();

  EXPECT_TRUE(is_near(row_of(ravigneaux_motions(), "i.vx"), expected, kTight));
}

TEST(MotionNetwork, OfASliderCrankIsItsLoopEquation) {
  const Mechanism mechanism = mechanism_of(kSliderCrank);

  const LabelledMatrix M_N = motion_matrices(mechanism.topology,
                                             mechanism.geometry,
                                             mechanism.graph,
                                             planar_basis(ScrewKind::twist, 1.0))
                                 .back();

  // Circuit d against a, b, c; a rotation at (x, y) has wz = 1, vx = y, vy = -x.
  MatX expected(3, 4);
  expected << -1, -1, -1, 0,  //
      0, -12, 0, 1,           //
      0, 9, 14, 0;
  EXPECT_TRUE(is_near(M_N.value, expected, kTight));
  EXPECT_EQ(M_N.columns, (std::vector<std::string>{"a.wz", "b.wz", "c.wz", "d.vx"}));
  EXPECT_EQ(M_N.rows, (std::vector<std::string>{"d.wz", "d.vx", "d.vy"}));
}

// One body between two pins: the cut-set of a holds b with the same sign.
TEST(ActionNetwork, OfABarIsItsEquilibrium) {
  const Mechanism mechanism = mechanism_of(
      "space: planar\nground: base\nbodies: [bar]\ncouplings:\n"
      "  a: {type: revolute, bodies: [base, bar], at: [1, 2]}\n"
      "  b: {type: revolute, bodies: [bar, base], at: [4, 0]}\n");

  const LabelledMatrix A_N = action_matrices(mechanism.topology,
                                             mechanism.geometry,
                                             mechanism.graph,
                                             planar_basis(ScrewKind::wrench, 1.0))
                                 .back();

  // A force at (x, y): along x it has the moment -y, along y the moment x.
  MatX expected(3, 4);
  expected << -2, 1, 0, -4,  //
      1, 0, -1, 0,           //
      0, 1, 0, -1;
  EXPECT_TRUE(is_near(A_N.value, expected, kTight));
}

TEST(Partition, SplitsTheColumnsBySecondaryAndPrimaryMagnitudes) {
  const Mechanism mechanism = mechanism_of(kSliderCrank);
  const LabelledMatrix M_N = motion_matrices(mechanism.topology,
                                             mechanism.geometry,
                                             mechanism.graph,
                                             planar_basis(ScrewKind::twist, 1.0))
                                 .back();

  const std::vector<LabelledMatrix> parts = partition_of(M_N, {"b.wz"});

  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].symbol, "M_NS");
  EXPECT_EQ(parts[0].columns, (std::vector<std::string>{"a.wz", "c.wz", "d.vx"}));
  EXPECT_EQ(parts[1].symbol, "M_NP");
  EXPECT_TRUE(is_near(parts[1].value, MatX(M_N.value.col(1)), 0.0));
}

}  // namespace
}  // namespace kinestat
