// A mesh of teeth that loses power, bound to numbers.
#pragma once

#include <optional>
#include <string_view>

#include "core/source.hpp"
#include "core/types.hpp"
#include "description/loss_description.hpp"
#include "expression/number_law.hpp"

namespace kinestat {

/// What the loss of a mesh may depend on.
inline constexpr std::string_view kSpeedOfTeeth = "speed";  ///< of the pitch point in the carrier
inline constexpr std::string_view kForceOfTeeth = "force";  ///< along it, of one planet

/// Its loss is that share of the power that the driving gear gives, seen from the carrier of the
/// mesh or from the ground (LossModel).
struct LossyMesh {
  CouplingId coupling;
  double share = 0.0;                         ///< 1 - η, not negative and below 1; 0 with a law
  std::optional<NumberLaw<double>> law = {};  ///< of the number that the file gives, where it names
                                              ///< one of these
  LossForm form = LossForm::fraction;         ///< what that number is
  double tooth_term = 0.0;                    ///< with LossForm::teeth
  SourceRange where;
};

/// The share of a mesh whose teeth roll at that speed [m/s] under that force [N]; empty where its
/// law has no value there, or not one from 0 to below 1.
std::optional<double> share_at(const LossyMesh& mesh, double speed, double force);

}  // namespace kinestat
