// Ratios that numbers of teeth make fractions.
#pragma once

#include <optional>

#include "description/mechanism_description.hpp"
#include "math/numbers/rational.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// The ratio of a case with one output without rounding: every mesh is that of the section `gears`,
/// z_1 (w_1 - w_c) + z_2 (w_2 - w_c) = 0 in its carrier c with z negative of a ring (Willis 1870),
/// every other coupling a hinge or rigid, and what the case knows of motions is zero or one speed.
/// Empty where the mechanism has other parts, and where the fraction is not what `ratio` is, the
/// one that was solved for.
std::optional<Rational> tooth_ratio(const MechanismDescription& description,
                                    const Mechanism& mechanism,
                                    const Case& which,
                                    double ratio);

}  // namespace kinestat
