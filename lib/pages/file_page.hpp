// What a page says of one file.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cases/analysis.hpp"
#include "core/diagnostic.hpp"
#include "core/source.hpp"
#include "draw/linkage/drawn_actions.hpp"
#include "draw/linkage/drawn_motion.hpp"
#include "report/text_blocks.hpp"
#include "studies/duty/efficiency_map.hpp"
#include "studies/mobility/report/mobility_report.hpp"
#include "studies/motion/report/motion_table.hpp"
#include "studies/simulation/report/simulation_report.hpp"
#include "studies/sweep/report/sweep_table.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"
#include "studies/transmissions/report/transmission_analysis.hpp"

namespace kinestat {

/// A file that a page offers to be saved.
struct PageData {
  std::string name;  ///< of the file
  std::string type;  ///< of its content: "application/json"
  std::string text;
};

/// A finite motion, and where the bodies are in it.
struct PageMotion {
  MotionTable table;
  std::vector<std::size_t> shown;  ///< of the rows of the table, those that are drawn
  DrawnMotion drawn;               ///< at these
  DrawnActions acting;             ///< likewise
};

/// A simulation, its rows those of a motion in time.
struct PageSimulation {
  PageMotion rows;
  SimulationBlocks blocks;
};

/// How the values of a case move with the parameters, in tables.
struct PageSensitivity {
  std::string label;  ///< of the case
  TextBlocks blocks;
};

/// What a duty asks of the mechanism, in tables and maps.
struct PageDuty {
  TextBlocks blocks;
  std::vector<EfficiencyMap> maps;
};

/// Passes that failed, or for which the file gives no reason, are empty; what was wrong is among
/// the findings.
struct FilePage {
  SourceFile source;
  Diagnostics found;
  std::optional<MechanismDescription> description;  ///< empty for a file that cannot be read
  std::optional<Analysis> analysis;
  std::optional<MobilityAnalysis> mobility;
  std::optional<PageMotion> motion;          ///< drawn only where there is an analysis
  std::optional<PageSimulation> simulation;  ///< likewise
  std::vector<PageSensitivity> sensitivity;  ///< of cases, where the file has parameters
  std::optional<PageDuty> duty;              ///< only beside an analysis
  std::optional<SweepTable> sweep;           ///< without rows where they are too many
  std::optional<SynthesisAnalysis> synthesis;
  std::optional<TransmissionAnalysis> transmissions;
  std::vector<Picture> schemes;  ///< of the best of these, a gear scheme each
  std::vector<PageData> data;
};

/// The name of the mechanism, or its file; "<stdin>" for standard input.
std::string page_title(const FilePage& page);

}  // namespace kinestat
