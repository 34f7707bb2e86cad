// Motions of many planar linkages at once, one in each lane of vectors.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "studies/motion/lanes/lane_question.hpp"
#include "studies/motion/lanes/lane_turn.hpp"

namespace kinestat {

/// So many linkages at once: wider vectors are compared one number after the other on machines
/// that do not have them.
inline constexpr std::size_t kMotionLanes = 4;

/// Follows the drives in steps, by a cubic and Newton's corrections. Where a correction is large or
/// the determinant of the closure small or quick to change, a lane takes the step again in parts;
/// where that does not help, or a rate may turn back between two steps, it is doubted: then another
/// way must decide. What a lane gives does not depend on the others.
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

  /// Least and greatest at the steps [rad].
  std::array<double, 2> transmission_angles(std::size_t lane) const;

  /// One number a lane.
  struct alignas(kMotionLanes * sizeof(double)) Group {
    double numbers[kMotionLanes] = {};
  };

 private:
  using Groups = std::vector<Group>;

  // What is known of a position of the drive.
  struct Point {
    Groups unknowns;
    Groups rates;  // by the drive
  };

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

  struct Angle {
    Group share;  // its squared sine
    Group along;
    Group across;
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
  void keep(std::size_t step);
  void add_value(std::size_t place, bool is_first);
  void find_value(const Place& place);
  void find_rate(const Place& place, Group& rate);
  void add_transmission(bool is_first);
  void find_turns();
  void add_turn(std::size_t watched, std::size_t lane, std::size_t step, const LaneRates& rates);
  LaneRates rates_within(std::size_t watched, std::size_t lane, std::size_t step) const;
  void go_to_turns(double from, double step);
  void go_between(const std::array<LaneTurn, kMotionLanes>& turns, double from, double step);

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
  std::vector<Point> kept_;         ///< at each step
  std::vector<Groups> kept_rates_;  ///< likewise, of the watched freedoms
  Groups turn_rates_;
  Groups least_;  ///< of each place
  Groups greatest_;
  Groups sums_;
  Groups counts_;  ///< dead points of each watched freedom
  Angle least_angle_;
  Angle greatest_angle_;
  std::array<std::vector<LaneTurn>, kMotionLanes> turns_of_lane_;
};

}  // namespace kinestat
