// What reports say of actions that equilibrium leaves open, and of how they were filled in.
#pragma once

#include "expression/file_units.hpp"
#include "record/record.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

struct SelfStressView {
  const Topology& topology;
  const SelfStress& stress;
  const FileUnits& units;  ///< the first action is one of them
};

const Record<SelfStressView>& self_stress_record();

struct CompletionView {
  const Topology& topology;
  const Completion& completion;
};

const Record<CompletionView>& completion_record();

}  // namespace kinestat
