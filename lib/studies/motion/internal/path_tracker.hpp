// Follows the closure of a network along its drives.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/motion_tolerance.hpp"
#include "studies/motion/internal/closure_blocks.hpp"
#include "studies/motion/internal/closure_system.hpp"
#include "studies/motion/internal/drive_line.hpp"
#include "studies/motion/internal/hermite_predictor.hpp"
#include "studies/motion/internal/path_point.hpp"
#include "studies/motion/internal/pivoted_qr.hpp"
#include "studies/motion/motion_solution.hpp"

namespace kinestat {

template <class Frames>
class PathTracker {
 public:
  explicit PathTracker(const MotionNetwork& network);

  /// Where all drives run together from these values to those [rad, or sizes of the mechanism]. A
  /// way that arrived beside a change point goes on from there.
  void set_range(std::span<const double> from, std::span<const double> to);

  /// Puts the drives where the share has them.
  void set_drives(double share, std::span<double> coordinates) const;
  PathPoint make_point() const;

  /// Closes a point with the drives where its share puts them; `moved` becomes the largest
  /// correction of a joint. The factors of the closure are then those of the point.
  bool close(PathPoint& point, double& moved);
  void stand_at(const PathPoint& point);  ///< likewise, as it is
  void find_rates(PathPoint& point);      ///< of one that was closed last

  void leave_out_touches() { looks_for_touches_ = false; }  ///< double change points are known

  /// What the rates of it miss of closure, by the fastest drive: above rounding, it cannot move.
  double missed_rate(const PathPoint& point) const;

  /// From `now`, which `before` led to, to the share; `now` becomes the point there or, where the
  /// way ends before, its end. `before` may be without rates.
  Arrival advance(PathPoint& now, PathPoint& before, double share);

  /// The least-squares minimum of what is missed, as far along the unknowns of `along`, if any.
  void find_nearest(PathPoint& point, bool moves_drives, std::span<const double> along = {});

  /// Directions in which the joints may move with the drives held, of the point closed last.
  std::vector<VecX> open_directions();

  /// Whether it misses by more than rounding: more equations than unknowns do not fit.
  bool closes_by_least_squares(const PathPoint& point) const;

  int open_count() const { return static_cast<int>(unknown_.size()) - qr_.rank(); }

  /// Passed since the last call.
  std::vector<SpecialPosition> take_special() { return std::exchange(special_, {}); }

  bool has_special() const { return !special_.empty(); }

  /// Whether the last way arrived so near a change point that the next one begins before it.
  bool is_beside_change_point() const { return resumption_.has_value(); }

  ClosureSystem<Frames>& system() { return system_; }

 private:
  using Parts = std::vector<int>;  // indices of blocks; -1: the whole closure
  Arrival follow(PathPoint& now, PathPoint& before, double share);
  Arrival follow_cables(PathPoint& now, PathPoint& before, double share);
  LeastArc least_arc(const PathPoint& point) const;
  void return_to(const Beginning& beginning, PathPoint& now);
  void end_at_lift_off(const Beginning& beginning, PathPoint& now);
  void turn_resumption(const DriveLine& last);
  std::optional<Resumption> lead_around(const Resumption& beside, const DriveLine& last);
  void gather(std::span<const int> columns, std::vector<double>& matrix) const;
  bool try_step(const PathPoint& now, const PathPoint& before, double share, PathPoint& next);
  void predict(const PathPoint& now, const PathPoint& before, double step);
  bool rest_passive(const PathPoint& now, PathPoint& next);
  void look_for_touch(const PathPoint& before, const PathPoint& now);
  static double rounding_of(std::span<const double> coordinates);
  bool keeps_branch(const PathPoint& now, const PathPoint& next, double moved);
  void find_blocks();
  void find_block_signs(PathPoint& point);
  bool keeps_orientation(const PathPoint& now, const PathPoint& next);
  Parts turned_over(const ArcPoint& a, const ArcPoint& b);
  double part_orientation(const ArcPoint& a, const ArcPoint& b, int part);
  Arrival walk_arc(PathPoint& now, double share);
  bool try_arc(const ArcPoint& from, double length, ArcPoint& to);
  void move_arc(std::span<const double> by, ArcPoint& point);
  void solve_arc(const std::vector<double>& tangent, double left, ArcPoint& point);
  bool correct_arc(const ArcPoint& from, double length, ArcPoint& to);
  bool find_tangent(const std::vector<double>& before, ArcPoint& point);
  void augmented_matrix(std::vector<double>& matrix) const;
  double orientation(const std::vector<double>& a, const std::vector<double>& b, int columns);
  double arc_orientation(const ArcPoint& a, const ArcPoint& b);
  ArcPoint arc_point(const PathPoint& now);
  void land(const ArcPoint& arc, PathPoint& now);
  bool arrive(const Destination& to, PathPoint& now);
  bool arrive_beside(const Destination& to, const Crossing& crossing, PathPoint& now);
  double find_limit(const ArcPoint& from, double length, ArcPoint& there);
  std::optional<ArcPoint> find_limit_at_crossing(const ArcPoint& from, double length, ArcPoint to);
  bool leads_on(const ArcPoint& crossing);
  void stop_at_limit(const ArcPoint& limit, double uncertainty, PathPoint& now);
  bool crosses_at_most(const ArcPoint& from,
                       double length,
                       const ArcPoint& to,
                       std::optional<Crossing>& crossing);
  std::optional<Crossing> find_crossing(const ArcPoint& from, double length, const Parts& parts);
  std::optional<Crossing> find_crossing_near(const ArcPoint& from, double reached);
  std::optional<Crossing> find_crossing_in(const ArcPoint& from, Vicinity at, const Parts& parts);
  std::optional<Surroundings> surround(const ArcPoint& from, Vicinity at, const Parts& parts);
  std::optional<ChangePlace> find_change_place(const ArcPoint& from,
                                               const Surroundings& around,
                                               std::size_t part);
  void note_crossing(const Crossing& crossing);
  void note_special(SpecialKind kind, const ArcPoint& point, double uncertainty);

  ClosureSystem<Frames> system_;
  PivotedQr qr_;
  std::vector<int> driven_;  ///< rates
  std::vector<int> drive_coordinates_;
  std::vector<int> unknown_;  ///< the other rates
  int passive_count_ = 0;
  double accepted_ = 0.0;  ///< closure error that may be left where Newton ends
  std::vector<ContactArc> arcs_;
  int rolling_count_ = 0;  ///< of the last rows
  DriveLine line_;
  bool follows_turns_ = false;
  bool has_surplus_ = false;
  bool is_square_ = false;            ///< as many conditions as unknowns, and none is passive
  std::vector<ClosureBlock> blocks_;  ///< empty where the closure is one
  HermitePredictor trail_;
  bool looks_for_touches_ = true;
  double flattening_ = 0.0;  ///< fall of the reciprocal condition in the last step, by the share
  std::vector<SpecialPosition> special_;
  std::optional<Resumption> resumption_;
  std::vector<double> matrix_;
  std::vector<double> augmented_;
  std::vector<double> right_;
  std::vector<double> solved_;
  std::vector<double> step_;
  std::vector<double> correction_;
  PathPoint trial_;
  Beginning beginning_;  ///< of the stretch that follow_cables is in
};

}  // namespace kinestat
