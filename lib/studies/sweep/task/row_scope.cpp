#include "studies/sweep/task/row_scope.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "core/contract.hpp"
#include "expression/units.hpp"

namespace kinestat {

namespace {

// Of the title of a column: "N*m", "rad/s/(mm/s)", or empty.
Quantity unit_named(std::string_view text) {
  if (text.empty()) {
    return {.value = 1.0, .dimension = {}};
  }
  const auto parsed = parse_unit(text);
  KINESTAT_EXPECTS(std::holds_alternative<UnitExpression>(parsed));
  const auto& unit = std::get<UnitExpression>(parsed);
  return {.value = unit.scale.factor(), .dimension = unit.dimension};
}

}  // namespace

RowNames::RowNames(const MechanismDescription& description, std::span<const SweepColumn> columns) {
  for (const ParameterDescription& one : description.parameters) {
    names_.push_back(one.name.text);
  }
  first_ = std::ssize(names_);
  for (const SweepColumn& one : columns) {
    names_.push_back(one.name);
  }
}

int RowNames::slot_of(const std::string& name) const {
  const auto at = std::ranges::find(names_, name);
  return at != names_.end() ? static_cast<int>(at - names_.begin()) : -1;
}

int RowNames::quantity_slot(const std::string& name) const {
  const auto at = std::find(names_.begin() + first_, names_.end(), name);
  return at != names_.end() ? static_cast<int>(at - names_.begin()) : -1;
}

RowScope::RowScope(const SweepPlan& plan, std::span<const SweepColumn> columns)
    : plan_(plan), first_(plan.slots().values.size()), slots_(plan.slots()) {
  for (const SweepColumn& column : columns) {
    const Quantity unit = unit_named(column.unit);
    units_.push_back(unit.value);
    slots_.values.push_back(unit);
    slots_.has_value.push_back(true);
  }
}

void RowScope::enter(std::span<const std::uint64_t> places) {
  for (std::size_t a = 0; a < places.size(); ++a) {
    const SweepAxis& axis = plan_.axes()[a];
    slots_.values[static_cast<std::size_t>(axis.parameter())] = axis.value_at(places[a]);
    slots_.has_value[static_cast<std::size_t>(axis.parameter())] = true;
  }
  plan_.evaluate_dependents(0, slots_, scratch_);
}

void RowScope::show(const SweepRow& row) {
  for (std::size_t q = 0; q < units_.size(); ++q) {
    slots_.values[first_ + q].value = row.values[q] * units_[q];
    slots_.has_value[first_ + q] = !std::isnan(row.values[q]);
  }
}

}  // namespace kinestat
