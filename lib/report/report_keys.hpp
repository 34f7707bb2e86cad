// The keys that reports of all forms share.
#pragma once

#include <span>
#include <string>

#include "core/diagnostic.hpp"
#include "mechanism/mechanism.hpp"
#include "network/network_matrices.hpp"
#include "record/record.hpp"

namespace kinestat {

/// What every report begins with.
struct HeadView {
  const std::string& file;  ///< path as the user gave it
  const MechanismDescription& description;
};

/// Behind the keys "kinestat" and "mechanism".
const Record<HeadView>& program_record();
const Record<HeadView>& mechanism_record();

struct GraphView {
  const Mechanism& mechanism;
  std::span<const LabelledMatrix> matrices;  ///< entries in the units of the file; may be none
};

const Record<GraphView>& graph_record();

/// Writes errors and warnings as a list.
void write_diagnostics(const Diagnostics& found, Archive& to);
Shape diagnostics_shape();

/// Those that every report begins with: program and mechanism. The view has `file` and
/// `description`.
template <class View>
void add_head(Record<View>& keys) {
  const auto head_of = [](const View& v) {
    return HeadView{.file = v.file, .description = v.description};
  };
  keys.part("kinestat", program_record(), head_of).not_in_tables().not_compared();
  keys.part("mechanism", mechanism_record(), head_of).not_in_tables();
}

/// The last one. The view has a pointer `found`.
template <class View>
typename Record<View>::Mark add_diagnostics(Record<View>& keys) {
  return keys
      .custom("diagnostics",
              diagnostics_shape(),
              "Errors and warnings of the analysis, in the order in which they were found.",
              [](const View& v, Archive& to) { write_diagnostics(*v.found, to); })
      .not_in_tables()
      .not_compared();
}

}  // namespace kinestat
