// What reports say of the count of Grübler and Kutzbach.
#pragma once

#include "mobility/grubler.hpp"
#include "record/record.hpp"

namespace kinestat {

struct GrublerView {
  const Topology& topology;
  const GrublerCount& count;
};

const Record<GrublerView>& grubler_record();

}  // namespace kinestat
