// What happens on the way of a finite motion, at the steps and between them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kinestat {

/// The kinds of events: a freedom comes to rest and turns back, the drive does not determine the
/// motion, it can go no further, a cable leaves its pulley, friction turns round.
inline constexpr std::string_view kDeadPointEvent = "dead_point";
inline constexpr std::string_view kSingularEvent = "singular";
inline constexpr std::string_view kLimitEvent = "limit";
inline constexpr std::string_view kLiftOffEvent = "lift_off";
inline constexpr std::string_view kFrictionReversalEvent = "friction_reversal";

/// What happens at a position of the drives that is none of the steps.
struct MotionEvent {
  std::string kind;           ///< "dead_point", "singular", "limit"
  std::string element;        ///< which freedom comes to rest, which drive goes no further, …
  int step = 0;               ///< the last step before; -1: on the way from the drawn position
  std::vector<double> drive;  ///< position of each drive, in its unit
  double uncertainty = 0.0;   ///< of that of the first drive
  double row = -1.0;  ///< where between the rows, 2.25 a quarter of the way from the third to the
                      ///< fourth; negative before the first
  std::vector<std::optional<double>> places;  ///< of a dead point among the rows: parallel to the
                                              ///< columns, those of drives and positions
  bool reverses = true;  ///< whether a freedom turns back at its dead point: not at an end of a
                         ///< motion that does not close
  /// Where friction turns round: what the columns come to from either side, as there they have no
  /// values; empty where the motion does not go on.
  std::vector<std::optional<double>> before = {};
  std::vector<std::optional<double>> after = {};

  std::optional<double> value_before(std::size_t column) const {
    return column < before.size() ? before[column] : std::nullopt;
  }

  std::optional<double> value_after(std::size_t column) const {
    return column < after.size() ? after[column] : std::nullopt;
  }

  /// Whether the column has another value after it than before: by more than beside a smooth place.
  bool is_jump_of(std::size_t column) const;
};

/// Places before and behind: in steps, or in a table where between the rows, as of an event. What
/// lies between the two rests. The same at an end.
struct PlacesAround {
  double before = 0.0;
  double after = 0.0;
};

/// Friction that turns round with the sliding of its coupling.
struct FrictionTurn {
  std::string coupling;
  std::size_t friction = 0;         ///< into Mechanism::frictions
  std::vector<PlacesAround> turns;  ///< at least one
};

}  // namespace kinestat
