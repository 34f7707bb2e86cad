// Whether numbers of a description depend on parameters that vary.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "description/mechanism_description.hpp"
#include "expression/parameters.hpp"

namespace kinestat {

/// Asks of values whether a parameter that varies stands in them. Both lists must outlive it.
class Dependence {
 public:
  Dependence(const ParameterTable& table, const std::vector<bool>& varies)
      : table_(table), varies_(varies) {}

  bool of(const Value& value) const {
    return std::ranges::any_of(value.expression.names(), [&](const std::string& name) {
      const int i = table_.index_of(name);
      return i >= 0 && varies_[static_cast<std::size_t>(i)];
    });
  }

  bool of(const std::vector<Value>& values) const {
    return std::ranges::any_of(values, [&](const Value& value) { return of(value); });
  }

  template <class Item>
  bool of(const std::optional<Item>& item) const {
    return item && of(*item);
  }

  bool of(const AxisDescription& axis) const { return of(axis.components); }

  bool of(const PointDescription& point) const { return of(point.coordinates); }

  bool of(const CouplingPoint& at) const {
    return of(at.point) || of(at.along_axis) ||
           std::ranges::any_of(at.of_bodies, [&](const auto& one) { return of(one.second); });
  }

  bool of(const ScrewDescription& screw) const {
    return of(screw.direction) || of(screw.at) || of(screw.pitch);
  }

  /// Of whatever shapes the coupling, its point excepted.
  bool of_shape(const CouplingDescription& coupling) const {
    return of(coupling.axis) || of(coupling.normal) || of(coupling.line) || of(coupling.slot) ||
           of(coupling.pitch) || of(coupling.lead) || of(coupling.tangent) ||
           of(coupling.line_of_action) || of(coupling.pressure_angle) ||
           of(coupling.normal_pressure_angle) || of(coupling.helix_angle) ||
           std::ranges::any_of(coupling.axes, [&](const AxisDescription& one) { return of(one); });
  }

  bool of(const LossDescription& losses) const {
    const auto of_loss = [&](const LossValue& loss) { return of(loss.value); };
    return (losses.gear_external && of_loss(*losses.gear_external)) ||
           (losses.gear_internal && of_loss(*losses.gear_internal)) ||
           std::ranges::any_of(losses.meshes, of_loss, &MeshLoss::loss);
  }

  /// Of any number of the coupling that is drawn.
  bool of_all(const CouplingDescription& coupling) const {
    const auto of_screw = [&](const ScrewDescription& screw) { return of(screw); };
    return of_shape(coupling) || of(coupling.at) || of(coupling.from) || of(coupling.to) ||
           (coupling.screw != nullptr && of(*coupling.screw)) ||
           std::ranges::any_of(coupling.freedoms, of_screw) ||
           std::ranges::any_of(coupling.constraints, of_screw);
  }

 private:
  const ParameterTable& table_;
  const std::vector<bool>& varies_;
};

}  // namespace kinestat
