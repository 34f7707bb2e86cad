// Which values of a case are rounding and are written as zero.
#pragma once

#include "report/analysis.hpp"

namespace kinestat {

/// Thresholds in SI: kReportZero of the largest value of the quantity in the case; a linear
/// quantity also of the largest angular one times the mechanism's length, and so on, because one
/// is computed from the other.
struct ZeroSnap {
  double angular = 0.0;  ///< [rad/s]
  double linear = 0.0;   ///< [m/s]
  double moment = 0.0;   ///< [N·m]
  double force = 0.0;    ///< [N]
  double power = 0.0;    ///< [W]
};

ZeroSnap find_zero_snap(const CaseAnalysis& analysis, double length);

/// The value, or +0 if it is below the threshold.
double snap(double value, double threshold);

}  // namespace kinestat
