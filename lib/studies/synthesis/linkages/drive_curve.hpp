// How a linkage follows its input: the range it can reach, its transmission angle, its poses.
#pragma once

#include <optional>

#include "studies/synthesis/linkages/linkage.hpp"

namespace kinestat {

/// The transmission angle μ is the angle between the force of the output dyad on the coupler and
/// what that force has to move: with a crank or a slider as input the line to the input's circle
/// point, with an inverted slider as input the normal of its line. Zero and π are dead points. Its
/// cosine is a function of one argument of the input coordinate x, so that limits and extremes
/// have closed forms.
class DriveCurve {
 public:
  DriveCurve(const Linkage& linkage, Drive drive);

  /// Whether x is an angle [rad]; else a displacement [length].
  bool is_cyclic() const { return input_.kind != DyadKind::slider; }

  /// x of a pose that the linkage meets: the angle of the crank from the line of centres (from the
  /// normal of the path of a slider, from the line to the point of an inverted one), in (-π, π];
  /// the displacement of a slider from the foot of its output's centre; the angle of the guide of
  /// an inverted slider from where its normal points to the output's centre.
  double coordinate_of(const Pose& pose) const;

  /// The sense in which the input passes a position by its derivatives: 1 where the coordinate
  /// grows with the parameter, -1 where it falls, 0 in a dead point. The order is 2 at least.
  int sense_of(const PositionJets& position) const;

  /// 1 or -1: on which side of the dead points the pose is; 0 in one, and where there are none.
  /// Of a four-bar the sign of (B - A) x (B0 - B).
  int side_of(const Pose& pose) const;

  /// cos μ at x; beyond ±1, or NaN, where the input cannot go.
  double cosine(double x) const;

  /// The pose at x on a side; empty where the input cannot go.
  std::optional<Pose> pose_at(double x, int side) const;

  /// The reachable arguments: of cos x, of x² or of x, see `Argument`; unbounded ones are infinite.
  struct Range {
    double low = 0.0;
    double high = 0.0;
  };

  enum class Argument { cosine, square, linear, none };

  Argument argument() const { return argument_; }

  Range range() const;

  /// At the ends of the range the output runs to infinity, so that nothing connects the sides.
  bool is_open_ended() const { return is_open_ended_; }

 private:
  void set_crank_input();
  void set_slider_input();
  void set_inverted_input();
  Point input_place(double x) const;
  double plane_angle(const Point& input_place, int side) const;
  Pose pose_of_inverted_input(double x, int side) const;

  Dyad input_;
  Dyad output_;
  Argument argument_ = Argument::none;
  bool is_open_ended_ = false;
  double zero_ = 0.0;      // the input's own coordinate at x = 0
  double constant_ = 0.0;  // s = constant + factor * argument
  double factor_ = 0.0;
  double over_root_ = 0.0;  // cos μ = over_root / sqrt(s) instead of s, with an inverted output
  bool is_over_root_ = false;
};

}  // namespace kinestat
