#include "mechanism/gears/internal/loss_check.hpp"

#include <algorithm>

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

void check_value(const LossValue& loss, const std::string& what, const SectionContext& context) {
  switch (loss.form) {
    case LossForm::fraction:
      context.number(loss.value, kLoss, what);
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
                        fmt::format("'losses' names coupling '{}', which is no mesh", name),
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

}  // namespace kinestat
