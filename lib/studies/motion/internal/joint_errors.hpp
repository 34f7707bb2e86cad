// What closure leaves uncertain of the joints of a network and of their rates.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "studies/motion/internal/closure_rows.hpp"
#include "studies/motion/internal/frame_path.hpp"
#include "studies/motion/internal/pivoted_qr.hpp"
#include "studies/motion/motion_network.hpp"
#include "studies/motion/state_bounds.hpp"

namespace kinestat {

/// The equations of a position, factored.
struct FactoredClosure {
  std::vector<RatesOfRow> rates_of_rows;
  std::span<const double> residuals;
  std::span<const double> jacobian;  ///< rows x rates, one column after the other
  std::span<const int> unknown;      ///< rates that the driven ones determine
  PivotedQr& qr;                     ///< of their columns
  double reach = 1.0;                ///< in sizes: no point of a joint is farther from the origin
};

/// How the joints move in that position. The errors are those of the driven ones.
struct JointMotion {
  const ClosureLevers& levers;  ///< moving with it
  bool is_bent = true;          ///< whether the derivatives of rates are asked for
  std::span<const double> rates;
  std::span<const double> bends;
  std::span<const double> driven_errors;
  std::span<const double> driven_bend_errors;
};

/// Running error analysis. What the joints are off by, δ, solves J δ = ρ at all times, ρ being what
/// the rows round; so what their rates and the derivatives of these are off by, δ' and δ'', solves
///     J δ' = ρ' - J' δ      and      J δ'' = ρ'' - J'' δ - 2 J' δ',
/// ρ' and ρ'' being what rounds where those are found. J, J' and J'' are the levers of the joints
/// in the rows and how they change with the motion: a joint counts by what it moves there, and
/// joints that turn about one line, as a screw and its nut, cancel. To keep that, all errors are
/// carried as shares of the sources they come from - what each row rounds, the correction that is
/// left, what the drives and the open motions are off by - and sizes are taken of what has been
/// summed over joints: of J' J⁻¹ in the rows, of S J⁻¹ for the pose of a body, S being the screws
/// below it. So J⁻¹, which is large where a screw is fine, enlarges the error of its joint and no
/// other, and counts once. What errors of joints make of each other is of second order, and bounded
/// by their sizes. Frames round by their distance from the origin. In radians and sizes of the
/// mechanism.
class JointErrors {
 public:
  explicit JointErrors(const MotionNetwork& network);

  /// `coordinates` are those of the joints; in a singular position only the root of what rounds is
  /// known.
  void stand_in(const FactoredClosure& closure,
                std::span<const double> coordinates,
                bool is_singular);

  /// `frame_of_body`, freedoms and lengths as in the network.
  StateBounds bounds(const JointMotion& motion, const Topology& topology);

 private:
  static constexpr int kOrders = 3;  // a position, its first and its second derivative
  using Orders = std::array<double, kOrders>;
  using Changes = std::array<const double*, kOrders + 1>;  // with each source; see sum
  using Lists = std::array<std::vector<double>, kOrders>;

  static Changes at_place(const Lists& lists, std::size_t first) {
    const double* once = lists[1].data() + first;
    return {lists[0].data() + first, once, lists[2].data() + first, once};
  }

  double factor(std::size_t row, std::size_t rate) const {
    return closure_->jacobian[rate * rows_ + row];
  }

  void find_shares(bool is_singular);
  void find_places(bool is_singular);
  void find_joints(int order, std::span<const double> values);
  void move_frames(const JointMotion& motion);
  void measure(const Jet* wrench, int tail_frame, int head_frame);
  Orders sum(const Changes& changes) const;
  double mixed(std::span<const double> sizes) const;
  double rounding(std::size_t r, const JointMotion& motion, int order) const;
  void find_rates(const JointMotion& motion);
  void add_open(int order, std::span<const double> values);
  void add_bracket(std::span<const double> screw, const double* sources, double* sums) const;
  BodyBounds bounds_of(int frame);
  void fill_joints(const JointMotion& motion, const Topology& topology, StateBounds& result) const;
  void fill_measures(const JointMotion& motion, StateBounds& result);

  const MotionNetwork& network_;
  std::optional<FactoredClosure> closure_;  // in which it stands
  std::size_t rows_ = 0;
  std::size_t screw_ = 6;         // coordinates of a screw
  std::size_t drives_ = 0;        // the first source of them
  std::size_t open_ = 0;          // likewise
  std::size_t roots_ = 0;         // likewise, of a singular position
  std::size_t orders_ = kOrders;  // that are asked for
  std::size_t sources_ = 0;
  std::size_t columns_ = 0;       // and behind them the rates and their derivatives
  std::vector<double> sizes_;     // of the coordinate of each rate
  std::vector<bool> is_turn_;     // of each rate
  std::vector<double> shares_;    // rates x columns
  Lists amounts_;                 // of the sources
  Lists joints_;                  // errors of each rate
  std::vector<FramePath> paths_;  // to each frame
  Lists moved_;                   // frames x screw x columns
  Lists changes_;                 // rows x sources
  Lists measured_;                // of the sources
  std::vector<double> apart_;
};

}  // namespace kinestat
