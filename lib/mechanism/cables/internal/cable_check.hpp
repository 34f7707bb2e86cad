// The numbers and references of the section `cables`.
#pragma once

#include "core/diagnostic.hpp"
#include "couplings/cable_geometry.hpp"
#include "description/cable_description.hpp"
#include "expression/file_units.hpp"
#include "mechanism/check/section_context.hpp"

namespace kinestat {

/// Complains of pulleys without a centre, of segments that join a body to itself and of cables that
/// cannot run as they are drawn, too. False if the couplings that the cables make cannot be bound,
/// for which there may be other reasons; they have their own complaints.
bool check_cables(const SectionContext& context);

/// Complains of segments that no tangent can follow and of those that pass through a pulley of the
/// same cable in the same plane, pulleys coaxial with one of its ends excepted: they stand side by
/// side. False also if the numbers of a station are wrong elsewhere, or a cable has not been
/// expanded.
bool check_routes(const SectionContext& context);

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
