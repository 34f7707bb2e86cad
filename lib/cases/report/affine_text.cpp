#include <cmath>

#include <fmt/format.h>

#include "cases/free_parameters.hpp"
#include "cases/report/case_text.hpp"
#include "mechanism/label_kind.hpp"
#include "report/number_format.hpp"

namespace kinestat {

namespace {

// A magnitude with what is needed to show it.
struct Shown {
  std::string name;
  QuantityKind kind = QuantityKind::force;
  const std::optional<AffineValue>& value;
};

template <class Use>
void for_each_magnitude(const Analysis& analysis, const CaseAnalysis& one, const Use& use) {
  const Topology& topology = analysis.mechanism.topology;
  const AffineCase& affine = affine_case(analysis, one);
  for (const AffineMagnitude& rate : affine.rates) {
    const bool turns = topology.freedoms[static_cast<std::size_t>(rate.index)].is_rotation;
    use(Shown{
        .name = topology.freedom_name(rate.index), .kind = rate_kind(turns), .value = rate.value});
  }
  for (const AffineMagnitude& action : affine.actions) {
    const bool turns = topology.actions[static_cast<std::size_t>(action.index)].is_couple;
    use(Shown{.name = topology.action_name(action.index),
              .kind = action_kind(turns),
              .value = action.value});
  }
}

// "- 3.831 h_z", or without the sign's space at the beginning.
void add_term(double coefficient, const std::string& name, std::string& sum) {
  const bool is_negative = coefficient < 0.0;
  sum += sum.empty() ? (is_negative ? "-" : "") : (is_negative ? " - " : " + ");
  sum += format_short(std::abs(coefficient));
  sum += name.empty() ? "" : " " + name;
}

std::string sum_text(const FileUnits& units,
                     const std::vector<FreeParameterLabel>& parameters,
                     const Shown& shown) {
  std::string sum;
  if (shown.value->constant != 0.0) {
    add_term(units.from_si(shown.kind, shown.value->constant), "", sum);
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double coefficient = units.from_si(shown.kind, shown.value->coefficients[i]);
    if (coefficient != 0.0) {
      add_term(coefficient, parameters[i].name, sum);
    }
  }
  return sum;
}

// "b_z, c_z in m, alpha in rad": the units in which the parameters count.
std::string parameters_text(const std::vector<FreeParameterLabel>& parameters) {
  std::vector<std::string> parts;
  for (const FreeParameterLabel& one : parameters) {
    parts.push_back(one.unit.empty() ? one.name : fmt::format("{} [{}]", one.name, one.unit));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

std::string affine_text(const Analysis& analysis, const CaseAnalysis& one) {
  const FileUnits& units = analysis.description.units;
  const std::vector<FreeParameterLabel>& parameters = affine_dependence(analysis).parameters;
  std::string lines;
  for_each_magnitude(analysis, one, [&](const Shown& shown) {
    lines += shown.value ? fmt::format("  {} [{}] = {}\n",
                                       shown.name,
                                       units.text(shown.kind),
                                       sum_text(units, parameters, shown))
                         : fmt::format("  {} is not affine in them\n", shown.name);
  });
  return lines.empty()
             ? lines
             : fmt::format(
                   "  With the free parameters {}:\n{}\n", parameters_text(parameters), lines);
}

}  // namespace kinestat
