// What a report of a mechanism file says, whole.
#pragma once

#include <span>

#include "cases/analysis.hpp"
#include "cases/certainty.hpp"
#include "core/diagnostic.hpp"
#include "network/network_matrices.hpp"
#include "record/record.hpp"
#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

/// Its parts; null what a command does not ask for.
struct ReportView {
  const std::string& file;  ///< path as the user gave it
  const MechanismDescription& description;
  const Mechanism* mechanism = nullptr;
  std::span<const LabelledMatrix> matrices = {};  ///< beside the mechanism
  const Analysis* analysis = nullptr;             ///< with cases
  const Certainty* certainty = nullptr;           ///< beside the analysis
  const Analysis* transmission = nullptr;         ///< with gears
  const MotionTable* motion = nullptr;
  const Diagnostics* found = nullptr;
};

const Record<ReportView>& report_record();

}  // namespace kinestat
