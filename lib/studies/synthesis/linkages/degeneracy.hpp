// Positions that repeat each other or do not turn, which leave dyads in families or none at all.
#pragma once

#include <span>
#include <string_view>

#include "studies/synthesis/positions/position_jets.hpp"

namespace kinestat {

/// Why there is no finite number of dyads, or which part of the answer is a family.
enum class Degeneracy {
  none,
  translation,           ///< no position turns against another, and their places lie on no circle
                         ///< and no line: no dyad
  parallelogram,         ///< nor does any here, on a circle: every point has the same crank
  straight_translation,  ///< nor here, on a line: every point has a slider, and none a crank
  repeated_position,     ///< a position is there twice: others are missing
  dependent,             ///< the conditions of the positions follow from each other
  straight_paths,        ///< a whole circle of points moves on straight lines (Cardan motion)
  sliding_lines,         ///< a whole pencil of lines slides on fixed points
  shared_line,           ///< a curve of circle points, and at most one dyad beside it
  shared_conic           ///< the positions leave a curve of circle points
};

/// The word in reports.
std::string_view word_of(Degeneracy reason);

/// A repeated position, or the kind of a translation, of any number of positions; else none. Two
/// translated positions are nothing special: as ever the centres of each point lie on a line.
Degeneracy find_degeneracy(std::span<const PositionJets> positions);

/// Whether two positions have the same pose but for rounding, turned by whole turns or not.
bool is_same_pose(const PositionJets& one, const PositionJets& other);

}  // namespace kinestat
