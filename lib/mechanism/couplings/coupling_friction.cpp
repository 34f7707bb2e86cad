#include "mechanism/couplings/coupling_friction.hpp"

#include <array>
#include <variant>

#include "math/numbers/dual.hpp"

namespace kinestat {

template <class Scalar>
std::optional<Scalar> tau_at(const CouplingFrictionOf<Scalar>& friction, const Scalar& speed) {
  if (!friction.tau_of_speed) {
    return friction.tau;
  }
  const Dimension dimension = dimension_of(QuantityKind::angular_velocity);
  const std::array variables = {LawVariable<Scalar>{
      .name = kSpeedOfFriction, .value = {.value = speed, .dimension = dimension}}};
  const auto found = friction.tau_of_speed->at(variables);
  const Scalar* const couple = std::get_if<Scalar>(&found);
  return couple != nullptr && value_of(*couple) >= 0.0 ? std::optional(*couple) : std::nullopt;
}

template std::optional<double> tau_at(const CouplingFriction&, const double&);
template std::optional<Dual> tau_at(const CouplingFrictionOf<Dual>&, const Dual&);

}  // namespace kinestat
