// What points of a duty may say of cases.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "expression/quantity.hpp"
#include "mechanism/duty/duty_plan.hpp"

namespace kinestat {

/// "motion" or "action".
std::string_view word_of(DutySide side);

/// What a magnitude of an actuator, given by index, measures.
QuantityKind measure_of(const Topology& topology, std::size_t actuator, DutySide side);

std::optional<std::size_t> find_actuator(const Topology& topology, std::string_view name);

std::optional<std::size_t> find_case(const Mechanism& mechanism, std::string_view label);

/// What to write instead of a label that no case has.
std::string cases_hint(const Mechanism& mechanism, std::string_view label);

/// Why a case cannot be a point, or nothing; and what to do about it.
std::string why_no_point(const Case& which);
inline constexpr std::string_view kBothSidesHint =
    "powers need both: 'motion' and 'action' of a case, 'input_action' of 'shift'";

/// Sets a magnitude that find_known finds.
void set_known(std::size_t known, DutySide side, double value, DutyPoint& point);

}  // namespace kinestat
