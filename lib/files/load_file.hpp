// From a path to a mechanism, with every complaint about the file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/analysis.hpp"
#include "core/diagnostic.hpp"
#include "core/source.hpp"
#include "io/read_file.hpp"

namespace kinestat {

/// A parameter given on the command line: PARAMETER=VALUE.
using Override = std::string;

/// What a command says about reading its files.
struct LoadOptions {
  std::vector<Override> overrides;       ///< of --set
  std::vector<std::string> curves = {};  ///< of --curve: NAME=FILE
  ReadLimits limits;                     ///< of --max-file-size
};

/// The paths of all that is read: the files themselves and the tables of curves.
std::vector<std::string> input_paths(const std::vector<std::string>& paths,
                                     const LoadOptions& options);

/// Reads and applies the overrides. `source` keeps the text for messages, also when the result is
/// empty, which it is iff an error was added.
std::optional<MechanismDescription> load_description(const std::string& path,
                                                     const LoadOptions& options,
                                                     SourceFile& source,
                                                     Diagnostics& found);

/// The same of a file that was read.
std::optional<MechanismDescription> read_description(const SourceFile& source,
                                                     const LoadOptions& options,
                                                     Diagnostics& found);

/// Gives parameters other values; complains of those that cannot be given.
void apply_overrides(const std::vector<Override>& overrides,
                     MechanismDescription& description,
                     Diagnostics& found);

/// Says that a file holds no mechanism, and what does: E0303.
void refuse_without_mechanism(const MechanismDescription& description, Diagnostics& found);

/// Binds a description that was read, gears included; one whose sweep asks for nothing but its
/// motion, which closes the drawn position, may be drawn apart. Empty iff an error was added.
std::optional<Loaded> bind_swept(MechanismDescription description,
                                 Diagnostics& found,
                                 const ShiftOptions& sizes = {});

/// Binds a description that was read, gears included. Empty iff an error was added.
std::optional<Loaded> bind_loaded(MechanismDescription description,
                                  Diagnostics& found,
                                  const ShiftOptions& sizes = {});

/// Reads, applies the overrides and binds, gears included, whose `sizes` may be more than the
/// usual; a file without a mechanism is an error. Empty iff an error was added.
std::optional<Loaded> load(const std::string& path,
                           const LoadOptions& options,
                           SourceFile& source,
                           Diagnostics& found,
                           const ShiftOptions& sizes = {});

}  // namespace kinestat
