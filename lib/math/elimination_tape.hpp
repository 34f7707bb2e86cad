// An elimination worked out once for a pattern, to be played again for other entries.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "math/equilibrate.hpp"

namespace kinestat {

/// a - b, or an exact zero where that is mere rounding of them, as in Elimination.
double without_rounding(double a, double b);

/// Where Elimination searches its pivots anew for every matrix, a tape keeps those of one matrix
/// and plays the same steps for others of its pattern. It takes the same decisions on what is
/// rounding, so that the answers of both differ by no more than another order of pivots makes. It
/// gives none where they would no longer be good: a pivot has become too small, a row has grown,
/// or what should follow from the other equations does not. The right-hand side is zero.
class EliminationTape {
 public:
  /// `matrix` has its entries where other matrices may have some, be they zero here; entries with
  /// `varies` false are the same in all of them. `last` are the columns whose unknowns are known,
  /// `wanted` those that solve is asked for. Empty if the matrix leaves unknowns open, or if the
  /// known ones depend on each other.
  static std::optional<EliminationTape> record(const SparseMatrix& matrix,
                                               const std::vector<bool>& varies,
                                               std::span<const int> last,
                                               std::span<const int> wanted);

  /// Numbers that playing needs, one set a thread; with them it allocates nothing.
  struct Workspace {
    std::vector<double> cells;
    std::vector<double> unknowns;
  };

  Workspace make_workspace() const;

  /// Sets the entry of that index in the pattern.
  void set(Workspace& workspace, std::size_t entry, double value) const {
    workspace.cells[entry] = value * scale_[entry];
  }

  /// Puts back what the last play has used up; entries that vary must be set after it.
  void reset(Workspace& workspace) const { workspace.cells = cells_; }

  /// Eliminates. False if this matrix needs pivots of its own.
  bool eliminate(Workspace& workspace) const;

  /// Solves for the wanted unknowns, given the known ones in the order of `last`; any number of
  /// times after eliminate.
  void solve(Workspace& workspace, std::span<const double> known) const;

  /// The unknown of a column that was wanted or known.
  double unknown(const Workspace& workspace, int column) const {
    return workspace.unknowns[static_cast<std::size_t>(column)] *
           scaling_.columns[static_cast<std::size_t>(column)];
  }

 private:
  friend class TapeRecorder;

  // One step on cells: target -= factor · source, or target = -factor · source where it fills in.
  struct Step {
    int target = 0;
    int source = 0;
  };

  // A row takes away a multiple of the pivot row.
  struct Subtraction {
    int entry = 0;  ///< the cell that vanishes
    int pivot = 0;
    int first_step = 0;
    int first_fill = 0;
    int end = 0;
  };

  struct Term {
    int cell = 0;
    int column = 0;
  };

  // An unknown as the sum of those that are solved before it.
  struct Substitution {
    int column = 0;
    int pivot = 0;
    int first_term = 0;
    int end = 0;
  };

  bool play(const Subtraction& subtraction, std::vector<double>& cells) const;
  bool is_good(const std::vector<double>& cells) const;

  Scaling scaling_;
  std::vector<double> scale_;  ///< of each entry: of its row times that of its column
  std::vector<double> cells_;  ///< entries, then what fills in; constant steps are done
  std::vector<Step> steps_;
  std::vector<Subtraction> subtractions_;  ///< that touch what varies, in order
  std::vector<int> pivots_;                ///< cells of the pivots that vary
  std::vector<int> surplus_;               ///< cells that must have vanished
  std::vector<Term> terms_;
  std::vector<Substitution> substitutions_;  ///< in their order
  std::vector<int> last_;
};

}  // namespace kinestat
