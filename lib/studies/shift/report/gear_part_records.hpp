// What reports say of the efficiency and the elements of a gear.
#pragma once

#include <optional>

#include "cases/analysis.hpp"
#include "record/record.hpp"

namespace kinestat {

const Record<CaseAnalysis>& gear_efficiency_record();

/// A clutch or brake in a gear.
struct ElementView {
  std::optional<double> torque;
  std::optional<double> lossy_torque;
  bool has_lossy_meshes = false;
  std::optional<double> slip;
};

const Record<ElementView>& element_record();

}  // namespace kinestat
