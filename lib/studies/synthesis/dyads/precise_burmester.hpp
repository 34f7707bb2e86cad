// Five positions in high precision: for positions so close that doubles cannot tell them apart.
#pragma once

#include <span>

#include "core/digit_limits.hpp"
#include "math/numbers/big_float.hpp"
#include "studies/synthesis/dyads/burmester.hpp"

namespace kinestat {

/// As solve_burmester, for positions that are given with more digits than a double holds. The
/// conditions and their null space are formed with a hundred digits; the two conics in it are well
/// conditioned again and are intersected in double, and their points improved by Newton with all
/// digits. What is returned is rounded to double; residuals are those before it is. The positions
/// count as rounded to `digits` decimals: so the digits of the answer are estimated.
BurmesterSolution solve_burmester_precisely(std::span<const PositionJetsOf<BigFloat>> positions,
                                            int digits = kMostDigits,
                                            const LastDecimal& decimal = {});

/// The nearest doubles.
PositionJets rounded(const PositionJetsOf<BigFloat>& position);

}  // namespace kinestat
