// Magnitudes as affine functions of free parameters, found by probing.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "math/numbers/bounded_number.hpp"

namespace kinestat {

/// constant + Σ coefficients[i] * parameter[i]. Cazangi 2008, annexes C and D, writes the moments
/// of bearings so, as functions of their positions along the axis.
struct AffineValue {
  double constant = 0.0;
  std::vector<double> coefficients;  ///< one a parameter

  friend bool operator==(const AffineValue&, const AffineValue&) = default;
};

/// A parameter at its value, and how far it is moved to see what depends on it; the step is not
/// zero and of the size in which the parameter is thought of.
struct FreeParameter {
  double value = 0.0;
  double step = 1.0;
};

/// The points at which the magnitudes must be known: first the values themselves, then each
/// parameter moved alone, then points at which all are moved differently, by no round numbers,
/// which tell an affine function from any other. One list of parameter values a point.
std::vector<std::vector<double>> affine_probes(std::span<const FreeParameter> parameters);

/// The magnitudes at one probe, and by how much each may be off there; empty where they have no
/// solution.
using Magnitudes = std::optional<std::vector<BoundedNumber>>;

/// The dependence of every magnitude on the parameters, or empty for one that is not affine in them
/// (to kAffine of its largest term) or has no solution at a probe. The probes are those of
/// affine_probes, of which the last, at which all are moved, may be nearer to the first;
/// `at_probes` is parallel to them; `scale` holds, for every magnitude, the size that counts as one
/// of its terms.
std::vector<std::optional<AffineValue>> fit_affine(std::span<const FreeParameter> parameters,
                                                   std::span<const std::vector<double>> probes,
                                                   std::span<const Magnitudes> at_probes,
                                                   std::span<const double> scale);

}  // namespace kinestat
