// A mesh of teeth that loses power, bound to numbers.
#pragma once

#include "core/source.hpp"
#include "core/types.hpp"

namespace kinestat {

/// Its loss is that share of the power that the driving gear gives, seen from the carrier of the
/// mesh or from the ground (LossModel).
struct LossyMesh {
  CouplingId coupling;
  double share = 0.0;  ///< 1 - η, not negative and below 1
  SourceRange where;
};

}  // namespace kinestat
