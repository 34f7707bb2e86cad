// What reports say of the count of Grübler and Kutzbach.
#pragma once

#include "record/record.hpp"
#include "studies/mobility/grubler.hpp"

namespace kinestat {

struct GrublerView {
  const Topology& topology;
  const GrublerCount& count;
};

const Record<GrublerView>& grubler_record();

}  // namespace kinestat
