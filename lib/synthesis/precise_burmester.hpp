// Five positions in high precision: for positions so close that doubles cannot tell them apart.
#pragma once

#include <span>

#include "math/big_float.hpp"
#include "synthesis/burmester.hpp"

namespace kinestat {

/// As solve_burmester, for positions that are given with more digits than a double holds. The
/// conditions and their null space are formed with a hundred digits; the two conics in it are well
/// conditioned again and are intersected in double, and their points improved by Newton with all
/// digits. What is returned is rounded to double. Digits that the positions do not have, such as
/// those of doubles, are taken for zeros.
BurmesterSolution solve_burmester_precisely(std::span<const PositionJetsOf<BigFloat>> positions);

/// The nearest doubles.
PositionJets rounded(const PositionJetsOf<BigFloat>& position);

}  // namespace kinestat
