#include "mechanism/gears/lossy_mesh.hpp"

#include <array>
#include <variant>

namespace kinestat {

std::optional<double> share_at(const LossyMesh& mesh, double speed, double force) {
  if (!mesh.law) {
    return mesh.share;
  }
  const std::array variables = {
      LawVariable<double>{
          .name = kSpeedOfTeeth,
          .value = {.value = speed, .dimension = dimension_of(QuantityKind::velocity)}},
      LawVariable<double>{
          .name = kForceOfTeeth,
          .value = {.value = force, .dimension = dimension_of(QuantityKind::force)}}};
  const auto found = mesh.law->at(variables);
  const double* const number = std::get_if<double>(&found);
  if (number == nullptr) {
    return std::nullopt;
  }
  const double share = mesh.form == LossForm::fraction     ? *number
                       : mesh.form == LossForm::efficiency ? 1.0 - *number
                                                           : *number * mesh.tooth_term;
  return share >= 0.0 && share < 1.0 ? std::optional(share) : std::nullopt;
}

}  // namespace kinestat
