#include "mechanism/internal/loss_binder.hpp"

#include <algorithm>
#include <cmath>

namespace kinestat {

namespace {

class LossBinder {
 public:
  LossBinder(const MechanismDescription& description, Evaluator& evaluator)
      : description_(description), losses_(*description.losses), evaluator_(evaluator) {}

  std::vector<LossyMesh> run() {
    std::vector<LossyMesh> result;
    for (std::size_t e = 0; e < description_.couplings.size(); ++e) {
      const CouplingDescription& coupling = description_.couplings[e];
      const bool is_mesh =
          coupling.type == CouplingType::gear || coupling.type == CouplingType::bevel_gear;
      const LossValue* loss = is_mesh ? loss_of(coupling) : nullptr;
      const double share = loss == nullptr ? 0.0 : share_of(*loss, coupling.name.text);
      if (share > 0.0) {
        result.push_back({.coupling = CouplingId{static_cast<int>(e)},
                          .share = share,
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
        return value * tooth_term(mesh);
    }
    return 0.0;
  }

  // 1/z1 + 1/z2, or |1/z1 - 1/z2| with a ring; 0 for a mesh that 'gears' does not have.
  double tooth_term(const std::string& mesh) {
    const GearsDescription* gears = description_.gears ? &*description_.gears : nullptr;
    if (gears == nullptr) {
      return 0.0;
    }
    const auto at = std::ranges::find(
        gears->meshes, mesh, [](const MeshDescription& one) { return one.name.text; });
    double sum = 0.0;
    for (const GearMember& member : gears->members) {
      const bool takes_part = at != gears->meshes.end() && (member.name.text == at->first.text ||
                                                            member.name.text == at->second.text);
      if (takes_part) {
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
};

}  // namespace

std::vector<LossyMesh> bind_losses(const MechanismDescription& description, Evaluator& evaluator) {
  return description.losses ? LossBinder(description, evaluator).run() : std::vector<LossyMesh>{};
}

}  // namespace kinestat
