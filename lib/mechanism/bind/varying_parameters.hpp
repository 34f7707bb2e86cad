// The numbers of a description that depend on varying parameters.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "description/mechanism_description.hpp"
#include "expression/parameters.hpp"

namespace kinestat {

/// The varying parameters of a table: tells whether they occur in parts of a description. Table and
/// list must outlive it.
class VaryingParameters {
 public:
  VaryingParameters(const ParameterTable& table, const std::vector<bool>& varies)
      : table_(table), varies_(varies) {}

  bool stand_in(const Value& value) const {
    return std::ranges::any_of(value.expression.names(), [&](const std::string& name) {
      const int i = table_.index_of(name);
      return i >= 0 && varies_[static_cast<std::size_t>(i)];
    });
  }

  bool stand_in(const std::vector<Value>& values) const {
    return std::ranges::any_of(values, [&](const Value& value) { return stand_in(value); });
  }

  template <class Item>
  bool stand_in(const std::optional<Item>& item) const {
    return item && stand_in(*item);
  }

  bool stand_in(const AxisDescription& axis) const { return stand_in(axis.components); }

  bool stand_in(const PointDescription& point) const { return stand_in(point.coordinates); }

  bool stand_in(const CouplingPoint& at) const {
    return stand_in(at.point) || stand_in(at.along_axis) ||
           std::ranges::any_of(at.of_bodies, [&](const auto& one) { return stand_in(one.second); });
  }

  bool stand_in(const ScrewDescription& screw) const {
    return stand_in(screw.direction) || stand_in(screw.at) || stand_in(screw.pitch);
  }

  /// Whether they occur in a number that shapes the coupling, its point excepted.
  bool stand_in_shape_of(const CouplingDescription& coupling) const {
    return stand_in(coupling.axis) || stand_in(coupling.normal) || stand_in(coupling.line) ||
           stand_in(coupling.slot) || stand_in(coupling.pitch) || stand_in(coupling.lead) ||
           stand_in(coupling.tangent) || stand_in(coupling.line_of_action) ||
           stand_in(coupling.pressure_angle) || stand_in(coupling.normal_pressure_angle) ||
           stand_in(coupling.helix_angle) ||
           std::ranges::any_of(coupling.axes,
                               [&](const AxisDescription& one) { return stand_in(one); });
  }

  bool stand_in(const LossDescription& losses) const {
    const auto of_loss = [&](const LossValue& loss) { return stand_in(loss.value); };
    return (losses.gear_external && of_loss(*losses.gear_external)) ||
           (losses.gear_internal && of_loss(*losses.gear_internal)) ||
           std::ranges::any_of(losses.meshes, of_loss, &MeshLoss::loss);
  }

  /// Whether they occur in any geometric number of the coupling.
  bool stand_in_any_of(const CouplingDescription& coupling) const {
    const auto of_screw = [&](const ScrewDescription& screw) { return stand_in(screw); };
    return stand_in_shape_of(coupling) || stand_in(coupling.at) || stand_in(coupling.from) ||
           stand_in(coupling.to) || (coupling.screw != nullptr && stand_in(*coupling.screw)) ||
           std::ranges::any_of(coupling.freedoms, of_screw) ||
           std::ranges::any_of(coupling.constraints, of_screw);
  }

 private:
  const ParameterTable& table_;
  const std::vector<bool>& varies_;
};

}  // namespace kinestat
