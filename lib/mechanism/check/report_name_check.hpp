// The names of quantities that `motion` and `sweep` report.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mechanism/check/section_context.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// The word of a sweep for what the input of a case feels of all inertia.
inline constexpr std::string_view kEquivalentInertiaWord = "equivalent_inertia";

/// Words that stand for more than one column, or for no coupling.
std::span<const std::string> sweep_report_words();

/// Each is a word, an actuator, or a quantity of a coupling: coupling.freedom, coupling.action; of
/// a sweep also a figure of a motion. Whether the coupling has that freedom or action shows only in
/// the topology.
void check_report_names(const std::vector<Name>& names,
                        std::span<const std::string> words,
                        std::string_view section,
                        const SectionContext& context);

/// Complains of freedoms and actions that the couplings of a topology do not have. Names without a
/// coupling are passed over.
void check_report_quantities(const std::vector<Name>& names,
                             const Topology& topology,
                             Diagnostics& found);

}  // namespace kinestat
