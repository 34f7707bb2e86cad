#include "mechanism/bind/bare_damping.hpp"

#include <string>

#include <fmt/format.h>

#include "expression/unit_quotient.hpp"

namespace kinestat {

namespace {

struct DampingKinds {
  QuantityKind action;
  QuantityKind rate;
  std::string_view per_coherent_rate;
};

constexpr DampingKinds kDampingOfTurn = {.action = QuantityKind::moment,
                                         .rate = QuantityKind::angular_velocity,
                                         .per_coherent_rate = "*s/rad"};
constexpr DampingKinds kDampingOfSlide = {
    .action = QuantityKind::force, .rate = QuantityKind::velocity, .per_coherent_rate = "*s/m"};

const DampingKinds& kinds_of_damping(bool turns) {
  return turns ? kDampingOfTurn : kDampingOfSlide;
}

}  // namespace

double bare_damping_unit(const FileUnits& units, bool turns) {
  const DampingKinds& kinds = kinds_of_damping(turns);
  return units.factor(kinds.action) / units.factor(kinds.rate);
}

void warn_of_bare_damping(const Value& value,
                          std::string_view title,
                          bool turns,
                          const FileUnits& units,
                          Evaluator& evaluator,
                          Diagnostics& found) {
  const DampingKinds& kinds = kinds_of_damping(turns);
  const std::optional<Quantity> typed = evaluator.quantity(value);
  if (!typed || !is_bare(typed->dimension) || typed->value == 0.0 ||
      units.factor(kinds.rate) == 1.0) {
    return;
  }
  const std::string coherent =
      fmt::format("{}{}", units.text(kinds.action), kinds.per_coherent_rate);
  const std::string of_file = unit_quotient(units.text(kinds.action), units.text(kinds.rate));
  const double in_coherent = typed->value / units.factor(kinds.rate);
  found.warning("W0313",
                value.where,
                fmt::format("{} is {:.4g} {}, because bare numbers count in {}",
                            title,
                            in_coherent,
                            coherent,
                            of_file),
                fmt::format("write the unit that is meant: {0:.6g} {1}, or {0:.6g} {2}",
                            typed->value,
                            coherent,
                            of_file));
}

}  // namespace kinestat
