// How a linkage follows its input: the range it can reach, its transmission angle, its poses.
#pragma once

#include <optional>

#include "studies/synthesis/linkages/linkage.hpp"

namespace kinestat {

/// The transmission angle μ is the angle between the force of the output dyad on the coupler and
/// what that force has to move: with a crank or a slider as input the line to the input's circle
/// point, with an inverted slider as input the normal of its line. Zero and π are dead points. Its
/// cosine is a function of one argument of the input coordinate x, so that limits and extremes
/// have closed forms; these keep the digits that the links have also next to dead points.
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

  /// μ at x [rad]; that of the dead point where the input cannot go.
  double transmission(double x) const;

  struct Transmission {
    double angle = 0.0;  ///< μ [rad]

    /// 1 or -1: on which side of the dead points; 0 in one, as far as the rounding of pose and
    /// dyads tells, and where there are none. Of a four-bar the sign of (B - A) x (B0 - B).
    int side = 0;
  };

  /// That of a pose that the linkage meets.
  Transmission transmission_of(const Pose& pose) const;

  /// 1 - |cos μ| at x; negative where the input cannot go.
  double reserve(double x) const;

  /// The pose at x on a side; empty where the input cannot go.
  std::optional<Pose> pose_at(double x, int side) const;

  /// Of which x the cosine of μ is a linear function: of cos x, of x², of x, or of none.
  enum class Argument { cosine, square, linear, none };

  Argument argument() const { return argument_; }

  /// What the input can reach, where nothing ends it infinite: values of |x|, or of x with a linear
  /// argument or none; and μ there [rad].
  struct Range {
    double low = 0.0;
    double high = 0.0;
    double low_transmission = 0.0;
    double high_transmission = 0.0;
  };

  Range range() const;

  /// At the ends of the range the output runs to infinity, so that nothing connects the sides.
  bool is_open_ended() const { return is_open_ended_; }

 private:
  // How far an argument is from 1 and from -1 if it is a cosine, else from 0.
  struct Offset {
    double from_one = 0.0;
    double from_minus_one = 0.0;
  };

  void set_crank_input();
  void set_slider_input();
  void set_inverted_input();
  void set_cosine(const BoundedNumber& constant,
                  const BoundedNumber& arm,
                  const BoundedNumber& length);
  BoundedNumber set_over_root();
  BoundedNumber coupler() const;
  Offset offset_of(double x) const;
  double below_one(const Offset& at) const;
  double above_minus_one(const Offset& at) const;
  double transmission_at(const Offset& at) const;
  Range range_of_angle() const;
  Range range_of_square() const;
  Range range_of_line() const;
  Point input_place(double x) const;
  double plane_angle(const Point& input_place, int side) const;
  Pose pose_of_inverted_input(double x, int side) const;

  Dyad input_;
  Dyad output_;
  Argument argument_ = Argument::none;
  bool is_open_ended_ = false;
  double zero_ = 0.0;             // the input's own coordinate at x = 0
  double below_one_ = 0.0;        // 1 - cos μ at the offset 0 from 1
  double above_minus_one_ = 0.0;  // 1 + cos μ at the offset 0 from -1
  double factor_ = 0.0;           // by which cos μ grows with the argument
  // With an inverted output cos μ = over_root / ρ instead, and ρ² - over_root² is linear.
  bool is_over_root_ = false;
  double over_root_ = 0.0;
  double excess_ = 0.0;  // ρ² - over_root² at the offset 0 from 1
};

}  // namespace kinestat
