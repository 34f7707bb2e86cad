// The parts of the section of a file on the page.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostic.hpp"
#include "core/source.hpp"
#include "pages/file_page.hpp"
#include "pages/html.hpp"
#include "pages/section_writer.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"

namespace kinestat {

/// The cases or gears of a file: a choice of them, a panel for each, and all side by side. Nothing
/// if there are none. The file must have an analysis.
void add_case_part(SectionWriter& section);

/// How many of the cases of a file are gears of its `shift`.
int gear_count(const Analysis& analysis);

/// The mechanism, moving if it does, else as the picture shows it; beside it what was found.
void add_summary_part(SectionWriter& section, const std::optional<Picture>& picture);

/// Whether a motion was found that the summary draws.
bool has_drawn_motion(const FilePage& page);

/// Likewise a simulation.
bool has_drawn_simulation(const FilePage& page);

/// Whether the summary has its drawing, as that of no other motion.
bool leads_with_simulation(const FilePage& page);

/// The drawing of the simulation, which a script plays in time.
void add_simulation_figure(SectionWriter& section);

/// The simulation: its tables, curves and, where the summary has another, its drawing. Of a file
/// that asks for one without getting it, that there is none.
void add_simulation_part(SectionWriter& section);

/// The finite motion: its tables and curves; the summary has its drawing. Of a file that asks for a
/// motion without getting one, that there is none.
void add_motion_part(SectionWriter& section);

/// What is wrong with the file, as on a terminal; words are broken into lines, the line of the file
/// with its carets is not.
void add_findings(const SourceFile& source, const Diagnostics& found, Html& html);

/// What was found: ratios and efficiencies of cases; gears; the motion; synthesised linkages. Six
/// significant digits, units of the file. Empty for a file of which nothing is known.
std::vector<std::string> result_sentences(const FilePage& page);

/// What it was found of: bodies, couplings, mobility and redundant constraints.
std::vector<std::string> count_sentences(const FilePage& page);

/// What a synthesis has found: the task, its dyads and the best linkage; of a task with choices
/// those of the first.
std::vector<std::string> synthesis_sentences(const SynthesisAnalysis& synthesis);

/// Adds the section of a file and gives its headings. Ids begin with `id`; the figures are
/// numbered on from `figures`.
std::vector<PageHeading> add_file_section(
    const FilePage& page, const std::string& id, PageForm form, int& figures, Html& html);

}  // namespace kinestat
