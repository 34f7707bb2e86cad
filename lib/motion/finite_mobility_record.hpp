// What reports say of motions beyond the instant.
#pragma once

#include "motion/finite_mobility.hpp"
#include "record/record.hpp"

namespace kinestat {

struct FiniteMobilityView {
  const Topology& topology;
  const FiniteMobility& finite;
};

const Record<FiniteMobilityView>& finite_mobility_record();

}  // namespace kinestat
