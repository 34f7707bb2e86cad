// What a motion comes to in a few figures: extremes and means of its columns.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "studies/motion/peak_search.hpp"
#include "studies/motion/report/motion_table.hpp"
#include "studies/motion/task/figures/time_pieces.hpp"

namespace kinestat {

/// What a value between the steps is looked at for.
enum class Look {
  peak,  ///< at a place of one column
  mean,  ///< where other columns are looked at, too
  end    ///< likewise; where friction has no direction there is none without it, either
};

/// Looks between the steps, at shares of the ranges of the drives; empty where nothing does.
struct BetweenSteps {
  /// The value of a column of the table; empty where there is none.
  std::function<std::optional<double>(std::size_t column, double share, Look look)> value;

  /// Whether actions that are missing there have no equilibrium, as where friction jams; others are
  /// lost in rounding beside a singular position.
  std::function<bool(double share)> is_jammed;
};

/// What is known of a column.
struct FigureColumn {
  bool is_climbed = false;    ///< its extremes are looked for between the steps
  bool is_bounded = false;    ///< of values that never grow without bound
  bool is_of_motion = false;  ///< of what follows from the motion alone
  bool is_checked = false;    ///< its mean is taken by half of the steps, too
  std::optional<ValueFolds> folds = {};
};

/// What columns have at a position, as in a MotionRow.
struct FigureValues {
  std::vector<std::optional<double>> values;
  std::vector<std::optional<double>> at_rest;
};

/// A position between two steps that figures are to see.
struct FigurePlace {
  double step = 0.0;   ///< in steps, of time in a motion in time, else of the way
  double share = 0.0;  ///< of the ranges of the drives
  FigureValues of;
  bool is_approach = false;  ///< beside a place where values jump or grow without bound: the
                             ///< limits of those that jump
  double beside = 0.0;       ///< of an approach: the step of that place
  /// Of what grows: what values are where four times and twice as much of the way is left.
  std::vector<std::vector<std::optional<double>>> farther = {};
  double weight = 0.0;        ///< of a point of a piece of time
  bool is_for_peaks = false;  ///< and not for means
};

/// What figures are to see beside the rows.
struct FigurePlaces {
  std::span<const FigurePlace> places;  ///< in order
  std::span<const TimePiece> pieces;    ///< whose points are among them
  std::span<const double> turns;        ///< steps at which values turn sharply, in order
};

/// Where a motion is at a share of the ranges of the drives.
struct FigureWhere {
  double drive = 0.0;  ///< position of the first drive, in its unit
  double step = 0.0;   ///< as of a FigurePlace
};

/// Fills the figures of a table whose rows stand at those shares of the ranges and those steps, and
/// whose events are known. Extremes are those of the steps and of the places between
/// them, of positions at dead points too; in the columns that are climbed, which may be fewer
/// than all, they are looked for between these, and of bounded ones where their values end, too.
/// All of them take what is `at_rest` while drives dwell. Means take the middle of an interval
/// where one of its ends has no value, as friction has none where it turns round. Where values grow
/// without bound on an approach, or towards a position that has none, there is no mean, and no
/// extreme in that sense. `where_at` answers where a share is, `share_at` the share at so many
/// steps.
void add_figures(std::span<const double> shares,
                 std::span<const double> steps,
                 const FigurePlaces& places,
                 const std::vector<FigureColumn>& columns,
                 const BetweenSteps& between,
                 const std::function<FigureWhere(double share)>& where_at,
                 const std::function<double(double step)>& share_at,
                 MotionTable& table);

}  // namespace kinestat
