// What closure leaves uncertain of the joints of a network and of their rates.
#pragma once

#include <span>
#include <vector>

#include "studies/motion/internal/closure_rows.hpp"
#include "studies/motion/internal/pivoted_qr.hpp"
#include "studies/motion/motion_network.hpp"
#include "studies/motion/state_bounds.hpp"

namespace kinestat {

/// The equations of a position, factored.
struct FactoredClosure {
  const MotionNetwork& network;
  std::vector<RatesOfRow> rates_of_rows;
  std::span<const double> residuals;
  std::span<const double> jacobian;  ///< rows x rates, one column after the other
  std::span<const int> unknown;      ///< rates that the driven ones determine
  PivotedQr& qr;                     ///< of their columns
  double reach = 1.0;                ///< in sizes: no point of a joint is farther from the origin
  double spread = 1.0;               ///< in sizes: no two points about which joints turn, or at
                                     ///< which the closure is taken, are farther from each other
};

/// Running error analysis: where the joints stand is off by the next correction and by rounding
/// that the inverse of the closure enlarges; the screws move by as much, and so do the rates and
/// their derivatives, enlarged once more. Frames round by their distance from the origin; what a
/// joint is off by moves the others by their distance from it alone. In radians and sizes of the
/// mechanism, one a rate.
class JointErrors {
 public:
  /// `coordinates` are those of the joints; in a singular position only the root of what rounds is
  /// known.
  JointErrors(const FactoredClosure& closure,
              std::span<const double> coordinates,
              bool is_singular);

  /// For these rates and their derivatives; the errors of those that are driven are given.
  void follow(std::span<const double> rates,
              std::span<const double> bends,
              std::span<const double> driven_errors,
              std::span<const double> driven_bend_errors);

  /// `frame_of_body`, freedoms and lengths as in the network.
  StateBounds bounds(const Topology& topology) const;

 private:
  struct Sums;

  void invert();
  std::vector<double> carried(const std::vector<double>& rows) const;
  void find_places(std::span<const double> coordinates, bool is_singular);
  void add_open(std::vector<double>& errors, const std::vector<double>& sizes) const;
  double mixed(const std::vector<double>& sizes) const;
  double misplaced(const Sums& sums) const;
  Sums sums_of(const RatesOfRow& rates) const;
  double steady_part(int row, const std::vector<double>& values) const;
  std::vector<Sums> sums_of_frames() const;
  BodyBounds bounds_of(const Sums& sums) const;
  void fill_joints(StateBounds& result) const;
  void fill_measures(const std::vector<Sums>& frames,
                     const Topology& topology,
                     StateBounds& result) const;
  bool is_rolling(int row) const;

  FactoredClosure closure_;
  int rows_ = 0;
  std::vector<double> inverse_;  // sizes: unknown x rows, one row of the closure after the other
  std::vector<double> coordinates_;  // of each rate, in size
  std::vector<double> places_;
  std::vector<double> rates_;
  std::vector<double> rate_errors_;
  std::vector<double> bends_;
  std::vector<double> bend_errors_;
};

}  // namespace kinestat
