// Whether a cable lies on its pulley as it is drawn.
#pragma once

#include "core/diagnostic.hpp"
#include "couplings/cable_geometry.hpp"
#include "description/cable_description.hpp"
#include "expression/file_units.hpp"

namespace kinestat {

/// A station between two straight segments of a cable, in numbers.
struct DrawnContact {
  const CableDescription* cable = nullptr;
  const CableStation* station = nullptr;
  CableStationGeometry pulley;
  CableSpan arrives;
  CableSpan leaves;
};

/// Warns (W0308) of points without a radius where the cable has two levers about the axis, which no
/// round pulley gives, and of a cable that goes around the far side and crosses itself, unless the
/// file says `turns` or it is a belt on two pulleys, crossed on purpose. Says nothing of a point,
/// or of a pulley whose centre is not known.
void check_contact(const DrawnContact& contact, const FileUnits& units, Diagnostics& found);

}  // namespace kinestat
