// Transmissions that were found, as mechanism files: described, written, held against the search.
#pragma once

#include "cases/analysis.hpp"
#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "files/output.hpp"
#include "studies/transmissions/report/transmission_analysis.hpp"

namespace kinestat {

/// The transmission in teeth, with its ladder in the section `shift`. Bodies are the shafts as the
/// report names them, and planets; set 1 has the members sun1, planet1, ring1, or inner1 and outer1
/// for planets in pairs. The losses of a set are shared by its meshes.
MechanismDescription describe_transmission(const TransmissionAnalysis& analysis,
                                           const TransmissionVariant& variant);

/// That mechanism with its gears solved, as of any file.
Analysis solve_transmission(const TransmissionAnalysis& analysis,
                            const TransmissionVariant& variant);

/// Solves the gears of that mechanism as any file's and notes in the variants that are listed what
/// comes of it. One that differs from the search is a warning, W0804.
void check_transmissions(TransmissionAnalysis& analysis, Diagnostics& found);

/// Writes <stem>.ladder_0.transmission_0.yaml and so on into the folder, all that are listed or
/// none, and notes their paths. A file that this program wrote is replaced. False iff an error was
/// added.
bool write_transmissions(TransmissionAnalysis& analysis,
                         const OutputOptions& output,
                         InputPaths inputs,
                         Diagnostics& found);

/// What the search tells of the gears of a transmission, at any stationary ratios.
std::vector<LadderGear> list_gears(const TransmissionTask& task,
                                   const TransmissionVariant& variant,
                                   const StationaryPoint& stationary_ratios);

}  // namespace kinestat
