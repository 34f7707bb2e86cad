#include "mechanism/bind/gear_places.hpp"

#include <algorithm>
#include <utility>

#include "core/contract.hpp"
#include "couplings/kinds.hpp"
#include "description/gear_expansion.hpp"
#include "description/number_range.hpp"
#include "mechanism/bind/varying_parameters.hpp"

namespace kinestat {

namespace {

// Whether more than teeth and modules may move, or what follows from these but the layout.
bool moves_more(const MechanismDescription& description, const VaryingParameters& varying) {
  const GearsDescription& gears = *description.gears;
  const auto of_member = [&](const GearMember& one) {
    return varying.stand_in(one.count) || varying.stand_in(one.load_sharing) ||
           varying.stand_in(one.centre_distance);
  };
  const auto of_mesh = [&](const MeshDescription& one) {
    return varying.stand_in(one.pressure_angle) || varying.stand_in(one.normal_pressure_angle) ||
           varying.stand_in(one.helix_angle) || varying.stand_in(one.at);
  };
  const auto of_axis = [&](const GearAxisDescription& one) {
    return varying.stand_in(one.centre_distance);
  };
  return varying.stand_in(gears.pressure_angle) || varying.stand_in(gears.normal_pressure_angle) ||
         varying.stand_in(gears.helix_angle) || std::ranges::any_of(gears.axes, of_axis) ||
         std::ranges::any_of(gears.members, of_member) ||
         std::ranges::any_of(gears.meshes, of_mesh);
}

bool has_losses_by_teeth(const MechanismDescription& description) {
  if (!description.losses) {
    return false;
  }
  const LossDescription& losses = *description.losses;
  const auto is_by_teeth = [](const LossValue& loss) { return loss.form == LossForm::teeth; };
  return (losses.gear_external && is_by_teeth(*losses.gear_external)) ||
         (losses.gear_internal && is_by_teeth(*losses.gear_internal)) ||
         std::ranges::any_of(losses.meshes, is_by_teeth, &MeshLoss::loss);
}

// Whether a clutch joins bodies of two axes, which coincide by their numbers alone.
bool clutches_two_axes(const MechanismDescription& description, const GearTrain& train) {
  const std::string& ground = description.ground.text;
  return std::ranges::any_of(description.couplings, [&](const CouplingDescription& coupling) {
    return (kind_of(coupling.type).engages || joins_one_axis(coupling.type)) &&
           coupling.tail.text != ground && coupling.head.text != ground &&
           train.axis_on(coupling.tail.text) != train.axis_on(coupling.head.text);
  });
}

// Whether a clutch joins bodies of one axis of which a member says how far it is: teeth of the
// others say it too.
bool clutches_given_distance(const MechanismDescription& description, const GearTrain& train) {
  const std::vector<GearMember>& members = description.gears->members;
  return std::ranges::any_of(description.couplings, [&](const CouplingDescription& coupling) {
    const int axis = train.axis_on(coupling.tail.text);
    return joins_one_axis(coupling.type) && axis >= 0 &&
           axis == train.axis_on(coupling.head.text) &&
           std::ranges::any_of(train.axes[static_cast<std::size_t>(axis)].members, [&](int m) {
             return members[static_cast<std::size_t>(m)].centre_distance.has_value();
           });
  });
}

}  // namespace

std::optional<GearPlaces> GearPlaces::make(const MechanismDescription& description,
                                           const ParameterTable& table,
                                           const std::vector<bool>& varies) {
  if (moves_more(description, VaryingParameters(table, varies)) || !has_all_meshes(description)) {
    return std::nullopt;
  }
  Diagnostics found;
  Evaluator evaluator(description, table, found);
  const GearTrain train = find_gear_train(description);
  auto numbers = bind_gear_numbers<double>(*description.gears, train, evaluator);
  auto frame = bind_gear_frame<double>(description, evaluator);
  if (!numbers || !frame || clutches_two_axes(description, train) ||
      clutches_given_distance(description, train)) {
    return std::nullopt;
  }
  GearPlaces places(description, *std::move(frame), *std::move(numbers));
  places.add_moving(table, varies);
  return places.teeth_.empty() || !has_losses_by_teeth(description)
             ? std::optional(std::move(places))
             : std::nullopt;
}

void GearPlaces::add_moving(const ParameterTable& table, const std::vector<bool>& varies) {
  const VaryingParameters varying(table, varies);
  const auto slot_of = [&](const std::string& name) { return table.index_of(name); };
  const GearsDescription& gears = *description_->gears;
  for (std::size_t m = 0; m < gears.members.size(); ++m) {
    const Value& teeth = gears.members[m].teeth;
    if (varying.stand_in(teeth)) {
      teeth_.push_back({.index = m, .value = SlotExpression(teeth.expression, slot_of)});
    }
  }
  for (std::size_t m = 0; m < gears.meshes.size(); ++m) {
    const std::optional<Value>& module =
        gears.meshes[m].module ? gears.meshes[m].module : gears.module;
    if (varying.stand_in(module)) {
      modules_.push_back({.index = m, .value = SlotExpression(module->expression, slot_of)});
    }
  }
}

bool GearPlaces::find(const Slots& slots, std::vector<Quantity>& scratch) {
  const FileUnits& units = description_->units;
  for (const Moving& one : teeth_) {
    const auto teeth = slot_number(one.value, QuantityKind::dimensionless, units, slots, scratch);
    if (!teeth || !kTeeth.holds(*teeth)) {
      return false;
    }
    numbers_.teeth[one.index] = description_->gears->members[one.index].internal ? -*teeth : *teeth;
  }
  for (const Moving& one : modules_) {
    const auto module = slot_number(one.value, QuantityKind::length, units, slots, scratch);
    if (!module || !kAboveZero.holds(*module)) {
      return false;
    }
    numbers_.module[one.index] = *module;
  }
  if (!rings_fit(frame_.layout.train, numbers_)) {
    return false;
  }
  auto layout = find_layout<double>(std::move(frame_.layout.train), numbers_);
  KINESTAT_EXPECTS(layout.has_value());  // distances follow from teeth, or stay
  frame_.layout = *std::move(layout);
  return true;
}

}  // namespace kinestat
