// The names of quantities that `motion` and `sweep` report.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mechanism/check/section_context.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// The word of a sweep for the equivalent inertia of all bodies at the input of a case.
inline constexpr std::string_view kEquivalentInertiaWord = "equivalent_inertia";

/// The words that a sweep may report, besides names of actuators and quantities of couplings.
std::span<const std::string> sweep_report_words();

/// Whether it is the place of a number in the report of a case: "power/input".
bool is_report_path(std::string_view name);

/// What has columns in a motion under its own name: of these bodies and of the loads, springs and
/// traced points of a description with a motion, and the whole.
std::vector<std::string> elements_of_motion(const MechanismDescription& description,
                                            std::span<const std::string> bodies);

/// Checks that each name is one of `words`, an actuator, or a quantity of a coupling, written
/// coupling.freedom or coupling.action; in a sweep it may also be a figure of a motion, in a motion
/// a coupling. Whether the coupling has this freedom or action is checked by
/// check_report_quantities.
void check_report_names(const std::vector<Name>& names,
                        std::span<const std::string> words,
                        std::string_view section,
                        const SectionContext& context);

/// Adds an error for each freedom or action that its coupling does not have. Names without a
/// coupling are ignored. Where the section has columns (`have_columns`), the hint tells how their
/// names are written.
void check_report_quantities(const std::vector<Name>& names,
                             bool have_columns,
                             const Topology& topology,
                             Diagnostics& found);

}  // namespace kinestat
