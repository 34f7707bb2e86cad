// What reports say of efficiencies and losses.
#pragma once

#include <span>

#include "power/power_flow.hpp"
#include "power/transmission_efficiency.hpp"
#include "record/record.hpp"

namespace kinestat {

struct EfficiencyView {
  const PowerFlow& flow;
  const TransmissionEfficiency* meshes = nullptr;  ///< null where no mesh loses anything
  LossModel preferred = LossModel::carrier;
};

const Record<EfficiencyView>& efficiency_record();

struct LossesView {
  const Topology& topology;
  std::span<const FrictionAction> frictions;
  const LossyState& state;
};

const Record<LossesView>& losses_record();

}  // namespace kinestat
