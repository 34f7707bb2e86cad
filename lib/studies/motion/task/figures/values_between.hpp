// The values of a motion between its rows.
#pragma once

#include <cstddef>
#include <functional>
#include <list>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "expression/file_units.hpp"
#include "studies/motion/followed_configurations.hpp"
#include "studies/motion/task/columns/motion_columns.hpp"
#include "studies/motion/task/figures/motion_figures.hpp"
#include "studies/motion/task/figures/unbounded_quotients.hpp"
#include "studies/motion/task/motion_position.hpp"

namespace kinestat {

/// What a column reads at a position, in the unit of the file.
std::optional<double> read_column(const std::vector<MotionReading>& readings,
                                  std::size_t reading,
                                  const MotionPosition& position,
                                  const FileUnits& units);

/// What is known of the drives of a table, and of the columns behind them.
std::vector<FigureColumn> figure_columns(
    const std::vector<MotionReading>& readings,
    std::size_t drives,
    const FileUnits& units,
    const std::function<bool(const MotionColumn& column)>& is_climbed);

/// Values at shares of the ranges of the drives. What quotients are made of there is shown to
/// `quotients`. All that is given must outlive it.
class ValuesBetween {
 public:
  ValuesBetween(const Mechanism& mechanism,
                const FoundMotion& motion,
                const MotionDetail& detail,
                const std::vector<MotionReading>& readings,
                const FileUnits& units,
                FollowedConfigurations& configurations,
                UnboundedQuotients& quotients);

  /// With what acts without friction where it has no direction; empty where there is none.
  /// Positions at which other columns are looked at are kept.
  std::optional<double> at(std::size_t reading, double share, Look look);

  /// Whether there is no equilibrium there.
  bool is_jammed(double share);

 private:
  struct Found {
    std::optional<MotionPosition> position;  // empty where the motion cannot be followed to it
    std::optional<MotionPosition> without_friction;
  };

  // What all columns read.
  struct Known {
    std::vector<std::optional<double>> moving;
    std::vector<std::optional<double>> at_rest;  // without friction; empty where it has a direction
    bool is_jammed = false;
  };

  Found find(double share, MotionPositions& positions);
  MotionPositions& positions_for(const std::optional<MotionDetail>& needs);
  const Known& known_at(double share);
  std::optional<double> read(std::size_t reading, const Found& found) const;

  const Mechanism& mechanism_;
  const FoundMotion& motion_;
  const std::vector<MotionReading>& readings_;
  const FileUnits& units_;
  FollowedConfigurations& configurations_;
  UnboundedQuotients& quotients_;
  MotionDetail detail_;
  MotionPositions positions_;
  std::list<std::pair<MotionDetail, MotionPositions>> plain_;  // with less than all of the detail
  std::map<double, Known> known_;
};

}  // namespace kinestat
