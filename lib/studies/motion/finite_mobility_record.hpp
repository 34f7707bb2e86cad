// What reports say of motions beyond the instant.
#pragma once

#include "record/record.hpp"
#include "studies/motion/finite_mobility.hpp"

namespace kinestat {

struct FiniteMobilityView {
  const Topology& topology;
  const FiniteMobility& finite;
};

const Record<FiniteMobilityView>& finite_mobility_record();

}  // namespace kinestat
