// Analyses of the library's files for the tests of this folder.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "cases/solve_cases.hpp"
#include "files/load_file.hpp"
#include "studies/synthesis/task/find_synthesis.hpp"

namespace kinestat {

/// Of a file below mechanisms/, its gears among the cases.
inline Analysis library_analysis(const std::string& name) {
  SourceFile source;
  Diagnostics found;
  const std::string path = std::string(KINESTAT_SOURCE_DIR) + "/mechanisms/" + name;
  std::optional<Loaded> loaded = load(path, {}, source, found);
  if (!loaded) {
    throw std::runtime_error("cannot read " + name);
  }
  return solve_cases(path, *std::move(loaded));
}

/// Of a file with a task of synthesis.
inline SynthesisAnalysis library_synthesis(const std::string& name) {
  SourceFile source;
  Diagnostics found;
  const std::string path = std::string(KINESTAT_SOURCE_DIR) + "/mechanisms/" + name;
  std::optional<MechanismDescription> description = load_description(path, {}, source, found);
  if (!description) {
    throw std::runtime_error("cannot read " + name);
  }
  std::optional<SynthesisAnalysis> analysis =
      find_synthesis(path, *std::move(description), {}, found);
  if (!analysis) {
    throw std::runtime_error("cannot solve " + name);
  }
  return *std::move(analysis);
}

}  // namespace kinestat
