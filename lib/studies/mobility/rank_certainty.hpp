// Whether the rank of a network is proved, and what it is of the numbers as typed.
#pragma once

#include <optional>
#include <string_view>

#include "math/elimination/exact_input_elimination.hpp"
#include "mechanism/bind/exact_input_mechanism.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// Ranks of M_N or A_N.
struct RankCertainty {
  int rank = 0;                    ///< by elimination of the numbers rounded to double
  int lower = 0;                   ///< proved of these: the bound of a solution proves its pivots
  int upper = 0;                   ///< proved by the pattern of their entries
  double dropped = 0.0;            ///< the largest entry that counted as zero
  std::optional<double> deciding;  ///< where rounding decides and the network is small: the last
                                   ///< singular value that one of both ranks counts, as a share
                                   ///< of the first; 0: mere rounding
  std::optional<ExactInputRank> exact_input;  ///< of the numbers as typed, where anybody asked
  std::string_view how = "numeric";  ///< why the rank is believed: structural, elimination,
                                     ///< modular, digits (60 of them), numeric

  /// Whether rounding to double decides.
  bool differs() const { return exact_input && exact_input->rank != rank; }
};

/// What doubles alone prove of M_N, and of A_N.
RankCertainty find_motion_certainty(const Mechanism& mechanism);
RankCertainty find_action_certainty(const Mechanism& mechanism);

/// Adds the rank as typed.
void add_exact_input_motions(const Mechanism& mechanism,
                             const ExactInputMechanism& exact_input,
                             RankCertainty& certainty);
void add_exact_input_actions(const Mechanism& mechanism,
                             const ExactInputMechanism& exact_input,
                             RankCertainty& certainty);

}  // namespace kinestat
