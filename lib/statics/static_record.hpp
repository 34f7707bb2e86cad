// What reports say of the actions of a case.
#pragma once

#include <span>

#include "expression/file_units.hpp"
#include "record/record.hpp"
#include "statics/cable_contact_state.hpp"
#include "statics/converter_state.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

struct StaticView {
  const Mechanism& mechanism;
  const Case& which;
  const StaticSolution& action;
  std::span<const CableContactState> contacts;  ///< of mechanism.contacts, or none
  std::span<const ConverterState> converters;   ///< of the case, or none
  const FileUnits& units;                       ///< self-stresses are for one of them
};

const Record<StaticView>& static_record();

}  // namespace kinestat
