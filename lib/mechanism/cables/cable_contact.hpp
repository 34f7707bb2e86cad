// Where a cable, belt or chain bends around a pulley.
#pragma once

#include <optional>
#include <string>

#include "core/source.hpp"
#include "core/types.hpp"

namespace kinestat {

/// A pulley between two segments of a cable, SI units.
struct CableContact {
  std::string name;    ///< "rope_wheel", also the name of the virtual link; unique in the mechanism
  CouplingId arrives;  ///< the segment before the contact, in the order of the cable
  CouplingId leaves;   ///< the segment after it
  std::optional<CouplingId> slips;  ///< the revolute of the virtual link; empty if it cannot slip
  double radius = 0.0;              ///< [m] signed: positive where the cable turns about the axis
  std::optional<double>
      wrap;  ///< contact angle θ with full turns [rad]; empty if the sense is not known
  std::optional<double> friction;  ///< coefficient μ
  double efficiency = 1.0;         ///< η of the pulley
  bool turns = false;  ///< whether η acts where the pulley turns, unless the cable slips
  SourceRange where;
};

}  // namespace kinestat
