// What a page says of one file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/diagnostic.hpp"
#include "core/source.hpp"
#include "report/analysis.hpp"
#include "report/mobility_report.hpp"
#include "report/synthesis_report.hpp"

namespace kinestat {

/// A file that a page offers to be saved.
struct PageData {
  std::string name;  ///< of the file
  std::string type;  ///< of its content: "application/json"
  std::string text;
};

/// Passes that failed, or for which the file gives no reason, are empty; what was wrong is among
/// the findings.
struct FilePage {
  SourceFile source;
  Diagnostics found;
  std::optional<MechanismDescription> description;  ///< empty for a file that cannot be read
  std::optional<Analysis> analysis;
  std::optional<MobilityAnalysis> mobility;
  std::optional<SynthesisAnalysis> synthesis;
  std::vector<PageData> data;
};

/// The name of the mechanism, or its file; "<stdin>" for standard input.
std::string page_title(const FilePage& page);

}  // namespace kinestat
