// A mesh of teeth that loses power, bound to numbers.
#pragma once

#include <optional>
#include <string_view>

#include "core/source.hpp"
#include "core/types.hpp"
#include "description/loss_description.hpp"
#include "expression/number_law.hpp"

namespace kinestat {

/// The variables on which the loss of a mesh may depend.
inline constexpr std::string_view kSpeedOfTeeth = "speed";  ///< of the pitch point in the carrier
inline constexpr std::string_view kForceOfTeeth = "force";  ///< in that direction, of one planet

/// A mesh with losses. The loss is a share of the power that the driving gear gives, as seen from
/// the carrier of the mesh or from the ground (LossModel).
struct LossyMesh {
  CouplingId coupling;
  double share = 0.0;                         ///< 1 - η, not negative and below 1; 0 with a law
  std::optional<NumberLaw<double>> law = {};  ///< the number that the file gives, if it depends on
                                              ///< one of these variables
  LossForm form = LossForm::fraction;         ///< the meaning of that number
  double tooth_term = 0.0;                    ///< with LossForm::teeth
  SourceRange where;
};

/// The share that a mesh loses if its teeth roll at this speed [m/s] under this force [N]. Empty if
/// its law has no value there, or one that is not in [0, 1).
std::optional<double> share_at(const LossyMesh& mesh, double speed, double force);

}  // namespace kinestat
