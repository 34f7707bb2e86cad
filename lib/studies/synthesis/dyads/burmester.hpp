// Five multiply separated positions: the Burmester points, and so all dyads.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/synthesis_tolerance.hpp"
#include "studies/synthesis/dyads/dyad.hpp"
#include "studies/synthesis/linkages/degeneracy.hpp"
#include "studies/synthesis/positions/position_jets.hpp"

namespace kinestat {

enum class BurmesterStatus {
  solved,    ///< four dyads, some of them perhaps not real
  family,    ///< infinitely many dyads, see `reason`
  no_digits  ///< the positions are too close to each other for their number of digits
};

/// The word in reports.
std::string_view word_of(BurmesterStatus status);

struct BurmesterSolution {
  BurmesterStatus status = BurmesterStatus::solved;
  Degeneracy reason = Degeneracy::none;
  std::vector<Dyad> dyads;  ///< real ones; in a family those that stand alone
  int imaginary_count = 0;  ///< dyads that are not real, counted with multiplicity

  /// The real part of one that is not real: of all the one with the least imaginary part. By how
  /// much it misses the positions its residual tells.
  std::optional<Dyad> nearest = std::nullopt;
  double reciprocal_condition =
      0.0;               ///< smallest by largest singular value of the scaled conditions
  double digits = 16.0;  ///< of the positions that the conditions keep, estimated
};

/// Exactly five positions in any grouping: PPPPP, PPPP-P, PPP-PP, PPP-P-P, PP-PP-P, PP-P-P-P,
/// P-P-P-P-P. The null space of the four conditions is a plane; in it, what makes seven numbers a
/// dyad (p = au + bv, q = bu - av) are two conics, and their four shared points the Burmester
/// points: the quartic, without the poles and circular points of the classical elimination. A crank
/// more than kLongCrank times as long as the task is large is a slider if the last decimal of the
/// positions explains the difference.
BurmesterSolution solve_burmester(std::span<const PositionJets> positions,
                                  const LastDecimal& decimal = {});

}  // namespace kinestat
