// What every report begins with: program, mechanism, coupling graph.
#pragma once

#include <span>
#include <string>

#include "mechanism/mechanism.hpp"
#include "network/network_matrices.hpp"
#include "record/record.hpp"

namespace kinestat {

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

}  // namespace kinestat
