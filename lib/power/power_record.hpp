// What reports say of the power flow of a case.
#pragma once

#include "power/power_flow.hpp"
#include "power/power_graph.hpp"
#include "power/transmission_efficiency.hpp"
#include "record/record.hpp"

namespace kinestat {

struct PowerView {
  const Mechanism& mechanism;
  const Case& which;
  const StaticSolution& action;
  const PowerFlow& flow;
  const PowerGraph& graph;
  const TransmissionEfficiency* efficiency = nullptr;  ///< null where no mesh loses anything
};

const Record<PowerView>& power_record();

}  // namespace kinestat
