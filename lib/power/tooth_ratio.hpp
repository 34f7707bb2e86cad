// Ratios as fractions of numbers of teeth.
#pragma once

#include <optional>

#include "description/mechanism_description.hpp"
#include "math/numbers/rational.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// The ratio of a case with one output, without rounding. A mesh of the section `gears` with the
/// carrier c obeys z_1 (w_1 - w_c) + z_2 (w_2 - w_c) = 0, z being negative for a ring (Willis
/// 1870). All other couplings must be hinges or rigid, and the known motions of the case must be
/// zero or have one common speed. Empty if the mechanism has other parts, or if the fraction
/// differs from `ratio`, the solved one.
std::optional<Rational> tooth_ratio(const MechanismDescription& description,
                                    const Mechanism& mechanism,
                                    const Case& which,
                                    double ratio);

}  // namespace kinestat
