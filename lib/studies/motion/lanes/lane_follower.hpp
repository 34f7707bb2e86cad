// Motions of many planar linkages at once, one in each lane of vectors.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "studies/motion/lanes/lane_dead_point.hpp"
#include "studies/motion/lanes/lane_extreme_targets.hpp"
#include "studies/motion/lanes/lane_group.hpp"
#include "studies/motion/lanes/lane_means.hpp"
#include "studies/motion/lanes/lane_question.hpp"

namespace kinestat {

/// Follows the drives in steps, by a cubic and Newton's corrections. Where a correction is large or
/// the determinant of the closure small or quick to change, a lane takes the step again in parts;
/// where that does not help, or a rate may turn back unseen even between positions that are nearer
/// to each other, it is doubted: then another way must decide. What a lane gives does not depend on
/// the others.
class LaneFollower {
 public:
  /// All lanes begin with the geometry of the mechanism from which the linkage was made.
  LaneFollower(LaneLinkage linkage, LaneQuestion question, const Geometry& geometry);

  void set(std::size_t lane, const Geometry& geometry);

  void follow();

  /// After follow: false where the rest says nothing.
  bool is_certain(std::size_t lane) const { return doubts_.numbers[lane] == 0.0; }

  /// Of the place of that index.
  LaneExtremes extremes(std::size_t place, std::size_t lane) const;

  /// Of the watched freedom of that index.
  int dead_points(std::size_t watched, std::size_t lane) const;

  /// Least and greatest [rad].
  std::array<double, 2> transmission_angles(std::size_t lane) const;

 private:
  using Group = LaneGroup;
  using Groups = LaneGroups;
  using Point = LanePoint;

  // Of the drive.
  struct Step {
    double from = 0.0;
    double to = 0.0;
    bool has_history = false;  // one of the same size lies before
  };

  struct Place {
    int joint = -1;  // of the tree
    int closing = -1;
  };

  Place place_of(int freedom) const;
  void find_frames();
  void find_columns();
  void solve();
  bool take_correction(bool is_first);
  void correct(const Group& which);
  void predict(const Step& step);
  void advance(double to, bool has_history);
  void advance_in_parts(const Step& step, int parts, const Group& determinant);
  void predict_part(double last, double part);
  bool find_again();
  void judge_change(const Group& before);
  void keep(int part);
  void add_value(std::size_t place, bool is_first);
  void find_value(const Place& place);
  void find_swings();
  void find_swing(const LaneClosing& closing, Group& first, Group& second);
  void find_bends();
  void find_rate(const Place& place, Group& rate, Group& bend);
  void find_transmission();
  void add_transmission(bool is_first);
  LaneLook& add_look();
  void look(LaneLook& at);
  void find_fastest(LaneLook& at) const;
  void find_turns();
  void judge(std::size_t lane, const LaneStretch& stretch);
  bool is_doubtful(std::size_t lane, const LaneStretch& stretch) const;
  HermiteCubic rate_in(std::size_t lane, const LaneStretch& stretch, std::size_t watched) const;
  void look_closer();
  void go_to_turns();
  void go_to_turn(std::size_t index, bool is_last, Group& which);
  void go_between(std::size_t lane, const LaneStretch& stretch, double part);
  void settle(const Group& which);
  void find_transmission_angles();
  PeakSearch search_for(const LaneTarget& target, std::size_t lane) const;
  void go_to_peaks();
  void go_to(double share, std::size_t lane);
  void take_values(const Group& which);

  LaneLinkage linkage_;
  LaneQuestion question_;
  int parts_ = 1;  ///< of each step
  std::vector<Place> places_;
  std::vector<Place> watched_;
  Groups xs_;  ///< of each freedom: the point about which it turns, in sizes, or where it slides
  Groups ys_;
  Groups senses_;  ///< of those that turn
  Group drive_;
  double drive_at_ = 0.0;
  Point now_;
  Point before_;
  Point earlier_;      ///< than that
  Point part_before_;  ///< likewise, of parts of a step
  Groups cosines_;     ///< of each frame
  Groups sines_;
  Groups shifts_x_;
  Groups shifts_y_;
  Groups turns_;
  Groups screws_x_;  ///< of each joint: the point about which it turns now, or where it slides
  Groups screws_y_;
  Groups matrix_;      ///< of the closure, row by row: the unknowns, what is missed, the drive
  Groups steps_;       ///< the last correction of each unknown
  Groups rates_;       ///< and their rates
  Group determinant_;  ///< as share of the columns
  Group now_determinant_;
  Group active_;  ///< above zero: the lane takes what is found
  Group missed_;  ///< above zero: the last correction may have led elsewhere
  Group again_;   ///< above zero: the lane takes the last step again, in parts
  Group doubts_;  ///< above zero: the lane is doubted
  Group value_;
  Groups bends_;    ///< derivatives of the rates of the unknowns
  Groups swings_;   ///< of each frame: its rate of turning,
  Groups moves_x_;  ///< that of its shift,
  Groups moves_y_;
  Groups curves_x_;  ///< and the derivative of this with all rates constant
  Groups curves_y_;
  std::vector<LaneLook> looks_;  ///< at each part, then nearer to each other
  std::size_t look_count_ = 0;
  LaneLook turn_;  ///< on the way to a dead point
  Groups least_;   ///< of each place, then of the transmission angle
  Groups greatest_;
  LaneMeans means_;
  Groups counts_;    ///< dead points of each watched freedom
  LaneAngle angle_;  ///< of transmission: the last one
  LaneAngle least_angle_;
  LaneAngle greatest_angle_;
  LaneExtremeTargets climbs_;
  std::array<std::vector<LaneStretch>, kMotionLanes> doubtful_;
  std::array<std::vector<LaneDeadPoint>, kMotionLanes> turns_of_lane_;
};

}  // namespace kinestat
