// The equations of one side of a case, in the two forms in which methods take them.
#pragma once

#include <optional>
#include <vector>

#include "math/elimination/sparse_matrix.hpp"
#include "math/numbers/rational.hpp"
#include "mechanism/mechanism.hpp"
#include "studies/benchmark/extreme.hpp"

namespace kinestat {

enum class ProblemSide { motion, action };

/// A x = b with some of x known, and what of x is asked for.
struct SolveProblem {
  // The node system: sparse, about an origin near the mechanism, in units of its size. Equations
  // that follow from others are left out.
  SparseMatrix matrix;
  std::vector<int> last;       ///< columns of the primary magnitudes
  std::vector<double> known;   ///< their values
  std::vector<double> right;   ///< empty: zero
  std::vector<int> secondary;  ///< columns of the secondary magnitudes

  // As the textbook has it: dense, in SI units, about the world origin. M_NS of the circuits for
  // motions; for actions the equilibrium of the bodies, which has the size of A_NS. Rows that
  // follow from others are left out.
  MatX dense;
  VecX dense_right;
  VecX units;  ///< of each secondary magnitude: SI per unit of the node system

  std::vector<Rational> exact;  ///< the secondary magnitudes for these very doubles, in its units
};

/// Why a case has no such problem.
enum class NoProblem {
  none,        ///< it has one
  not_asked,   ///< no magnitude of this side is known
  open,        ///< the known magnitudes leave others open
  dependent,   ///< they contradict each other, or the loads
  too_large,   ///< more than kLargestProblem unknowns
  no_unknowns  ///< everything is known
};

/// Dense methods take n³ operations, and singular values many times those.
inline constexpr int kLargestProblem = 400;

struct ProblemAnswer {
  NoProblem reason = NoProblem::none;
  std::optional<SolveProblem> problem;  ///< if there is no reason against it
};

/// Friction and losses of meshes do not count. Of known magnitudes that depend on each other and
/// agree some are left out, and are unknowns.
ProblemAnswer make_problem(const Mechanism& mechanism,
                           const Case& which,
                           ProblemSide side,
                           const Extreme& extreme);

}  // namespace kinestat
