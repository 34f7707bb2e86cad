#include "mechanism/gears/internal/loss_binder.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "couplings/kinds.hpp"

namespace kinestat {

namespace {

class LossBinder {
 public:
  LossBinder(const MechanismDescription& description, Evaluator& evaluator, Diagnostics& found)
      : description_(description),
        losses_(*description.losses),
        evaluator_(evaluator),
        found_(found) {}

  std::vector<LossyMesh> run() {
    std::vector<LossyMesh> result;
    for (std::size_t e = 0; e < description_.couplings.size(); ++e) {
      const CouplingDescription& coupling = description_.couplings[e];
      const LossValue* loss = joins_wheels(coupling.type) ? loss_of(coupling) : nullptr;
      if (loss != nullptr) {
        result.push_back({.coupling = CouplingId{static_cast<int>(e)},
                          .share = share_of(*loss, coupling.name.text),
                          .where = loss->value.where});
      }
    }
    return result;
  }

 private:
  const LossValue* loss_of(const CouplingDescription& coupling) const {
    const auto own = std::ranges::find(
        losses_.meshes, coupling.name.text, [](const MeshLoss& one) { return one.coupling.text; });
    if (own != losses_.meshes.end()) {
      return &own->loss;
    }
    const std::optional<LossValue>& usual =
        coupling.internal ? losses_.gear_internal : losses_.gear_external;
    return usual ? &*usual : nullptr;
  }

  double share_of(const LossValue& loss, const std::string& mesh) {
    const double value = number(loss.value);
    switch (loss.form) {
      case LossForm::fraction:
        return value;
      case LossForm::efficiency:
        return 1.0 - value;
      case LossForm::teeth:
        return share_by_teeth(loss, value, mesh);
    }
    return 0.0;
  }

  // k (1/z1 + 1/z2), or k |1/z1 - 1/z2| with a ring.
  double share_by_teeth(const LossValue& loss, double k, const std::string& mesh) {
    const std::optional<double> term = tooth_term(mesh);
    if (!term) {
      found_.error("E0303",
                   loss.value.where,
                   fmt::format("mesh '{}' has no teeth to find its loss from", mesh),
                   "write the loss itself, or describe the mesh in 'gears'");
      return 0.0;
    }
    const double share = k * *term;
    if (share < 1.0) {
      return share;
    }
    found_.error(
        "E0305",
        loss.value.where,
        fmt::format("'k' of the loss of mesh '{}' cannot be {:.6g}: with its teeth the mesh "
                    "would lose {:.6g} of its power",
                    mesh,
                    k,
                    share),
        fmt::format("give less than {:.6g}; usual are values near 0.2", 1.0 / *term));
    return 0.0;
  }

  // Empty for a mesh that 'gears' does not have.
  std::optional<double> tooth_term(const std::string& mesh) {
    const auto name_of = [](const MeshDescription& one) { return one.name.text; };
    if (!description_.gears) {
      return std::nullopt;
    }
    const GearsDescription& gears = *description_.gears;
    const auto at = std::ranges::find(gears.meshes, mesh, name_of);
    if (at == gears.meshes.end()) {
      return std::nullopt;
    }
    double sum = 0.0;
    for (const GearMember& member : gears.members) {
      if (member.name.text == at->first.text || member.name.text == at->second.text) {
        sum += (member.internal ? -1.0 : 1.0) / number(member.teeth);
      }
    }
    return std::abs(sum);
  }

  double number(const Value& value) {
    return evaluator_.number(value, QuantityKind::dimensionless).value_or(0.0);
  }

  const MechanismDescription& description_;
  const LossDescription& losses_;
  Evaluator& evaluator_;
  Diagnostics& found_;
};

}  // namespace

std::vector<LossyMesh> bind_losses(const MechanismDescription& description,
                                   Evaluator& evaluator,
                                   Diagnostics& found) {
  return LossBinder(description, evaluator, found).run();
}

}  // namespace kinestat
