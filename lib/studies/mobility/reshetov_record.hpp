// What reports say of the table of Reshetov.
#pragma once

#include "network/freedom_counts.hpp"
#include "record/record.hpp"
#include "studies/mobility/reshetov.hpp"

namespace kinestat {

struct ReshetovView {
  const Topology& topology;  ///< in space
  const ReshetovTable& table;
  std::optional<MotionCounts> exact;  ///< in space; empty without dimensions
};

const Record<ReshetovView>& reshetov_record();

}  // namespace kinestat
