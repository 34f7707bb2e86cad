// The equations that close a network: what they miss, and how that changes with the joints.
#pragma once

#include <span>
#include <vector>

#include "studies/motion/internal/closure_rows.hpp"
#include "studies/motion/internal/planar_frames.hpp"
#include "studies/motion/internal/spatial_frames.hpp"
#include "studies/motion/internal/turns.hpp"
#include "studies/motion/motion_network.hpp"

namespace kinestat {

/// Lengths in sizes of the mechanism, so that turns and slides are of one order. The rates of all
/// joints are the unknowns; `Frames` is PlanarFrames or SpatialFrames. Its buffers serve a thread.
template <class Frames>
class ClosureSystem {
 public:
  explicit ClosureSystem(const MotionNetwork& network);

  int row_count() const { return row_count_; }

  int rate_count() const { return rate_count_; }

  /// All joints at zero.
  std::vector<double> drawn_coordinates() const;

  const std::vector<double>& drawn_angles() const { return first_angles_; }

  /// Frames, residuals, derivatives towards the rates; full turns are counted from the angles.
  void evaluate(std::span<const double> coordinates, std::span<const double> angles);

  /// Of the last evaluation: one a row, and rows x rates, one column after the other.
  const std::vector<double>& residuals() const { return residuals_; }

  const std::vector<double>& jacobian() const { return jacobian_; }

  double largest_residual() const;

  /// The coupling of each row.
  const std::vector<int>& row_couplings() const { return row_couplings_; }

  std::vector<RatesOfRow> rates_of_rows() const;

  /// In sizes, at least 1: now no joint is farther from the origin, and no pitch longer.
  double reach() const;

  /// Which rows miss a length, the others an angle.
  const std::vector<bool>& is_length() const { return is_length_; }

  /// Moves the joints by a step of their rates.
  void move(std::span<const double> step, std::span<double> coordinates) const;

  /// Counts the turns of the followed angles on to the last evaluation.
  void follow_angles(std::span<double> angles) const;

  /// Σ |step| of turns: no followed angle changes by more.
  double total_turn(std::span<const double> step) const;

  /// Frames that move with these rates and their derivatives.
  std::vector<typename Frames::template Frame<Jet>> moving_frames(
      std::span<const double> coordinates,
      std::span<const double> rates,
      std::span<const double> rate_rates) const;

  /// Of frames that move.
  ClosureLevers levers(const std::vector<typename Frames::template Frame<Jet>>& frames) const;

  /// Second derivatives of the residuals.
  std::vector<double> residual_bends(
      const std::vector<typename Frames::template Frame<Jet>>& frames,
      std::span<const double> rate_rates,
      std::span<const double> angles) const;

  /// The same with its points in sizes of the mechanism.
  MeasuredFreedom in_sizes(MeasuredFreedom measured) const {
    measured.measure.tail_point /= length_;
    measured.measure.head_point /= length_;
    return measured;
  }

  /// The position of a measured freedom, in sizes, with its derivatives where frames move.
  template <class S>
  S position(const MeasuredFreedom& measured,
             const std::vector<typename Frames::template Frame<S>>& frames) const;

  /// Of the last evaluation.
  const std::vector<typename Frames::template Frame<double>>& frames() const { return frames_; }

 private:
  template <class S>
  using Frame = typename Frames::template Frame<S>;
  template <class S>
  using Vector = typename Frames::template Vector<S>;
  template <class S>
  using Screw = typename Frames::template Screw<S>;
  using Plain = Vector<double>;

  using Row = FramedRow<Plain>;

  template <class S>
  struct Span {
    Vector<S> along;
    Vector<S> from;
    S length = 0.0;
    S tail_angle = 0.0;
    S head_angle = 0.0;
  };

  void add_row(const ClosureRow& closure);
  void add_path(int from, int to, Row& row) const;
  TurnAxis axis_between(int tail_frame, int head_frame) const;
  std::array<bool, 3> find_linear(const ClosureCondition& condition, const TurnAxis& turns) const;
  void place_rolling(const MotionNetwork& network);
  template <class S>
  Span<S> span_of(const Row& row, const std::vector<Frame<S>>& frames) const;
  template <class S>
  S scalar_residual(const Row& row,
                    const std::vector<Frame<S>>& frames,
                    std::span<const double> angles) const;
  template <class S>
  Screw<S> gradient(const Row& row, int direction, const std::vector<Frame<S>>& frames) const;
  void write_gradient(const Row& row, int r, const Screw<double>& wrench);
  template <class S>
  void find_screws(const ClosureJoint& joint,
                   int frame,
                   const std::vector<Frame<S>>& frames,
                   std::vector<Screw<S>>& screws) const;
  void find_frames(std::span<const double> coordinates);

  double length_ = 1.0;
  int row_count_ = 0;
  int rate_count_ = 0;
  int coordinate_count_ = 0;
  std::vector<ClosureJoint> joints_;
  std::vector<Row> rows_;
  std::vector<RollingRow> rollings_;
  std::vector<int> coordinate_of_rate_;
  std::vector<MeasuredFreedom> measures_;
  std::vector<int> row_couplings_;
  std::vector<bool> is_length_;
  std::vector<double> first_angles_;
  std::vector<Frame<double>> frames_;
  std::vector<Screw<double>> screws_;
  std::vector<double> residuals_;
  std::vector<double> jacobian_;
};

}  // namespace kinestat
