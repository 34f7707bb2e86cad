// What no simulation follows, for errors and for the help page.
#pragma once

#include <string>
#include <string_view>

#include "core/diagnostic.hpp"

namespace kinestat {

/// In the order of the help page.
enum class SimulationLimit {
  friction_of_several,  ///< of a coupling with several freedoms
  converter,
  loss_by_force,
  loss_without_hinges,  ///< of teeth whose gears no hinges join with a carrier
  freewheel,
  unguided_body,  ///< that only contacts, teeth and cables hold
  ball,
  idle_inertia,  ///< or loads, in a freedom that no other body feels
  contact_actuator
};

/// An error that says what to write instead; `element` is that with its quotation marks.
void refuse(SimulationLimit limit, SourceRange where, std::string_view element, Diagnostics& found);

/// The names of all, one after the other.
std::string simulation_limits();

}  // namespace kinestat
