#include "mechanism/gears/internal/mesh_loss_binder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "couplings/kinds.hpp"

namespace kinestat {

namespace {

constexpr NumberRule kLoss = {
    .kind = QuantityKind::dimensionless,
    .range = kLostShare,
    .allowed = "the share of the power that is lost, from 0 to below 1: 2 % is 0.02"};

constexpr NumberRule kLossEfficiency = {
    .kind = QuantityKind::dimensionless,
    .range = kKeptShare,
    .allowed = "the share of the power that is left, above 0 and at most 1: 98 % is 0.98"};

constexpr NumberRule kToothFactor = {.kind = QuantityKind::dimensionless,
                                     .range = kNotNegative,
                                     .allowed = "a number that is not negative"};

bool is_law(const LossValue& loss) {
  const auto names = loss.value.expression.names();
  return std::ranges::any_of(names, [](const std::string& name) {
    return name == kSpeedOfTeeth || name == kForceOfTeeth;
  });
}

// The law of a loss, checked where teeth roll at 1 m/s under 1 N.
std::optional<NumberLaw<double>> law_of(const LossValue& loss, Evaluator& evaluator) {
  const std::array samples = {
      LawVariable<double>{
          .name = kSpeedOfTeeth,
          .value = {.value = 1.0, .dimension = dimension_of(QuantityKind::velocity)}},
      LawVariable<double>{.name = kForceOfTeeth,
                          .value = {.value = 1.0, .dimension = dimension_of(QuantityKind::force)}}};
  return evaluator.law(loss.value, QuantityKind::dimensionless, samples);
}

// Real teeth lose some hundredths. Who writes 0.98 means the efficiency.
void doubt(double fraction,
           const LossValue& loss,
           const std::string& what,
           const SectionContext& context) {
  constexpr double kUnlikely = 0.3;
  if (fraction > kUnlikely) {
    context.found.warning(
        "W0314",
        loss.value.where,
        fmt::format("{} is {:.6g}, the fraction of the power that is lost", what, fraction),
        fmt::format("if it is the efficiency, write {{eta: {}}}", loss.value.expression.text()));
  }
}

void check_value(const LossValue& loss, const std::string& what, const SectionContext& context) {
  if (is_law(loss)) {
    (void)law_of(loss, context.evaluator);
    return;
  }
  switch (loss.form) {
    case LossForm::fraction:
      if (const std::optional<double> fraction = context.number(loss.value, kLoss, what)) {
        doubt(*fraction, loss, what, context);
      }
      return;
    case LossForm::efficiency:
      context.number(loss.value, kLossEfficiency, "'eta' of " + what);
      return;
    case LossForm::teeth:
      context.number(loss.value, kToothFactor, "'k' of " + what);
      return;
  }
}

bool has_teeth(const Name& coupling, const MechanismDescription& description) {
  return description.gears &&
         std::ranges::any_of(description.gears->meshes, [&](const MeshDescription& mesh) {
           return mesh.name.text == coupling.text;
         });
}

// A worm or a rack is a mesh, but no axis of a carrier stands between it and its gear.
const CouplingDescription* find_unlike(const std::string& name,
                                       const MechanismDescription& description) {
  const auto at = std::ranges::find_if(description.couplings, [&](const auto& coupling) {
    const bool is_unlike = has_teeth(coupling.type) && !joins_wheels(coupling.type);
    return is_unlike && coupling.name.text == name;
  });
  return at == description.couplings.end() ? nullptr : &*at;
}

void refuse_unlike(const MeshLoss& mesh, const CouplingDescription& coupling, Diagnostics& found) {
  found.error("E0313",
              mesh.coupling.where,
              fmt::format("'losses' names '{}', a {}; only meshes of gears lose a share of their "
                          "power",
                          coupling.name.text,
                          word_of(coupling.type)),
              coupling.type == CouplingType::worm
                  ? fmt::format("a worm has 'friction:' in 'couplings', for example {}: {{…, "
                                "friction: 0.1}}",
                                coupling.name.text)
                  : "leave it out; the guide of the rack may have 'friction:'");
}

void check_mesh(const MeshLoss& mesh, const SectionContext& context) {
  const std::string& name = mesh.coupling.text;
  const bool is_mesh = context.names.meshes.contains(name);
  if (!is_mesh && context.names.couplings.contains(name)) {
    context.found.error("E0313",
                        mesh.coupling.where,
                        fmt::format("'losses' names coupling '{}', which is not a mesh", name),
                        fmt::format("a bearing or slider has 'friction:' in 'couplings', for "
                                    "example {}: {{…, friction: 0.1}}",
                                    name));
  } else {
    context.names.meshes.check(mesh.coupling, "'losses' names", context.found);
  }
  if (const CouplingDescription* unlike = find_unlike(name, context.description)) {
    refuse_unlike(mesh, *unlike, context.found);
  }
  check_value(mesh.loss, fmt::format("the loss of mesh '{}'", name), context);
  if (is_mesh && mesh.loss.form == LossForm::teeth &&
      !has_teeth(mesh.coupling, context.description)) {
    context.found.error("E0303",
                        mesh.loss.value.where,
                        fmt::format("mesh '{}' has no teeth to find its loss from", name),
                        "write the loss itself, or describe the mesh in 'gears'");
  }
}

}  // namespace

void check_losses(const SectionContext& context) {
  if (!context.description.losses) {
    return;
  }
  const LossDescription& losses = *context.description.losses;
  if (losses.gear_external) {
    check_value(*losses.gear_external, "'gear_external' of 'losses'", context);
  }
  if (losses.gear_internal) {
    check_value(*losses.gear_internal, "'gear_internal' of 'losses'", context);
  }
  for (const MeshLoss& mesh : losses.meshes) {
    check_mesh(mesh, context);
  }
}

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
        result.push_back(is_law(*loss)
                             ? by_law(CouplingId{static_cast<int>(e)}, *loss, coupling.name.text)
                             : LossyMesh{.coupling = CouplingId{static_cast<int>(e)},
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

  LossyMesh by_law(CouplingId coupling, const LossValue& loss, const std::string& mesh) {
    LossyMesh result{.coupling = coupling, .form = loss.form, .where = loss.value.where};
    result.law = law_of(loss, evaluator_);
    if (loss.form == LossForm::teeth) {
      const std::optional<double> term = tooth_term(mesh);
      if (!term) {
        refuse_without_teeth(loss, mesh);
      }
      result.tooth_term = term.value_or(0.0);
    }
    return result;
  }

  void refuse_without_teeth(const LossValue& loss, const std::string& mesh) {
    found_.error("E0303",
                 loss.value.where,
                 fmt::format("mesh '{}' has no teeth to find its loss from", mesh),
                 "write the loss itself, or describe the mesh in 'gears'");
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
      refuse_without_teeth(loss, mesh);
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
