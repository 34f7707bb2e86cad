// The section `losses`: what the meshes lose.
#pragma once

#include <optional>
#include <vector>

#include "description/value.hpp"

namespace kinestat {

/// `carrier`: losses by the rolling power of a mesh, seen from its carrier; `absolute`: by the
/// power through each coupling (Cazangi 2008, 4.4.4).
enum class LossModel { carrier, absolute };

/// How a loss is written.
enum class LossForm {
  fraction,    ///< what is lost of the power, as a share
  efficiency,  ///< what is left, as a share
  teeth        ///< k of efficiency = 1 - k (1/z1 + 1/z2), with - if one of the two is a ring
};

struct LossValue {
  LossForm form = LossForm::fraction;
  Value value;
};

struct MeshLoss {
  Name coupling;  ///< a mesh of `gears`, or a coupling of gears
  LossValue loss;
};

struct LossDescription {
  LossModel model = LossModel::carrier;
  std::optional<LossValue> gear_external;  ///< of every mesh of two external gears
  std::optional<LossValue> gear_internal;  ///< of every mesh with a ring
  std::vector<MeshLoss> meshes;
  SourceRange where;
};

}  // namespace kinestat
