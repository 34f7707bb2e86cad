// Where the values of a motion turn sharply or jump: at the points of curves, where the law of a
// drive changes its acceleration, and where friction turns round.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "studies/motion/followed_configurations.hpp"
#include "studies/motion/task/figures/motion_figures.hpp"
#include "studies/motion/task/figures/sharp_bends.hpp"
#include "studies/motion/task/friction_sliding.hpp"
#include "studies/motion/task/motion_position.hpp"

namespace kinestat {

/// What columns have at a position, at a share of the ranges.
using ValuesAt = std::function<FigureValues(const MotionPosition& position, double share)>;

/// What is special between the steps and at them.
struct SpecialSteps {
  std::span<const FrictionPlace> sliding;  ///< at each row, and between them where it is otherwise:
                                           ///< where friction turns round it jumps
  std::span<const FrictionTurn> turns;     ///< those that are events, in steps
  std::span<const std::vector<SpringState>> springs;  ///< of each row: those that act one way alone
                                                      ///< begin and cease to
  std::span<const std::optional<std::vector<int>>> coast_flanks;  ///< of each row that is solved,
                                                                  ///< as in CaseAnalysis: where
                                                                  ///< teeth change their flank
                                                                  ///< forces have corners
  std::span<const double> poles;        ///< in steps: where speeds may grow without bound
  std::span<const FreedomRates> rates;  ///< of each row: where they bend sharply peaks are narrow
};

/// Where friction turns round, and what the columns come to from either side; empty where the
/// motion does not go on.
struct FrictionReversal {
  std::string coupling;
  double step = 0.0;
  std::vector<std::optional<double>> before = {};
  std::vector<std::optional<double>> after = {};
};

struct Corners {
  std::vector<FigurePlace> places;
  std::vector<double> steps;  ///< at which values turn sharply or jump, in order
  std::vector<double> turns;  ///< those at which they turn sharply
  std::vector<FrictionReversal> reversals;
  std::vector<TimePiece> pieces;  ///< of a motion in time; their points are among the places

  FigurePlaces view() const { return {.places = places, .pieces = pieces, .turns = turns}; }
};

/// In order: the places between the steps at which a curve of the mechanism, over time, a position
/// or a speed, is at one of its points; the values at the corners of the laws of drives, before and
/// behind a jump of their acceleration; points of short pieces between corners in time; where a
/// spring begins or ceases to act, and teeth change their flank; and what is approached from either
/// side where friction turns round or rests, and at poles. None of a motion that passes more than
/// some ten thousand.
Corners find_corners(const Mechanism& mechanism,
                     const FoundMotion& motion,
                     const MotionDetail& detail,
                     const SpecialSteps& special,
                     const ValuesAt& values_at,
                     FollowedConfigurations& configurations);

}  // namespace kinestat
