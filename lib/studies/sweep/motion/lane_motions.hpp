// The motions of several states of a sweep at once, where they are planar linkages.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mechanism/bind/rebind.hpp"
#include "studies/motion/lanes/lane_follower.hpp"
#include "studies/sweep/motion/swept_motion.hpp"
#include "studies/sweep/report/sweep_rows.hpp"

namespace kinestat {

/// Each worker has its own. It binds nothing but the places of couplings, and leaves every state
/// that is not clear to the whole motion.
class LaneMotions {
 public:
  /// What is passed must outlive it; `varies` is of each parameter. Empty where figures are of more
  /// than positions of freedoms and transmission angles, where the mechanism is no linkage of
  /// turning and sliding pairs, and where parameters move more than it or the motion itself.
  static std::optional<LaneMotions> make(const MechanismDescription& description,
                                         const Mechanism& mechanism,
                                         const SweptMotion& asked,
                                         const std::vector<bool>& varies);

  /// Takes the parameters of a state into a lane; false where the state must be bound as a whole.
  bool load(std::size_t lane, const Slots& slots);

  void follow() { follower_.follow(); }

  /// After follow: false where the whole motion must decide.
  bool fill(std::size_t lane, std::span<const SweepColumn> columns, SweepRow& row) const;

 private:
  // Where a figure is found.
  struct Source {
    MotionFigure figure = MotionFigure::range;
    int place = -1;  ///< of the question, if it is of a position
    std::vector<std::size_t> watched;
  };

  LaneMotions(const FileUnits& units,
              Rebinder rebinder,
              Geometry geometry,
              std::vector<Source> sources,
              std::vector<bool> turns,
              LaneFollower follower);

  static bool find_sources(const Mechanism& mechanism,
                           const SweptMotion& asked,
                           const MotionNetwork& network,
                           LaneQuestion& question,
                           std::vector<Source>& sources);
  std::optional<double> value_of(const Source& source, std::size_t lane) const;

  const FileUnits* units_;
  Rebinder rebinder_;
  Geometry geometry_;
  double length_;
  std::vector<Source> sources_;  ///< of each figure
  std::vector<bool> turns_;      ///< of each place
  LaneFollower follower_;
};

}  // namespace kinestat
