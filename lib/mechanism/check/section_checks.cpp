#include "mechanism/check/section_checks.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "mechanism/cases/load_binder.hpp"
#include "mechanism/check/report_name_check.hpp"
#include "mechanism/gears/internal/mesh_loss_binder.hpp"
#include "mechanism/motion_figure.hpp"

namespace kinestat {

namespace {

void check_outlines(const SectionContext& context) {
  for (const BodyDescription& body : context.description.bodies) {
    for (const PointDescription& point : body.outline) {
      context.point(point);
    }
  }
}

// Their couplings or actuators.
void check_knowns(const std::vector<Assignment>& knowns, const SectionContext& context) {
  const DeclaredNames& names = context.names;
  for (const Assignment& known : knowns) {
    const std::string owner = known.target.text.substr(0, known.target.text.find('.'));
    const bool is_dotted = owner.size() < known.target.text.size();
    const bool is_declared =
        is_dotted ? names.couplings.contains(owner) : names.actuators.contains(owner);
    const Name target{.text = owner, .where = known.target.where};
    if (!is_declared && is_dotted) {
      names.couplings.check(target, "a case gives a motion or action of", context.found);
    } else if (!is_declared) {
      names.check_actuator(target, "a case names", context.found);
    }
  }
}

}  // namespace

void check_sections(const SectionContext& context) {
  check_outlines(context);
  check_losses(context);
  check_shift(context);
  check_duty(context);
  check_motion(context);
  check_dynamics(context);
  check_simulation(context);
  check_sweep(context);
  check_synthesis(context);
}

namespace {

void check_end(const Name& name,
               std::string_view role,
               const CaseDescription& one,
               const SectionContext& context) {
  const DeclaredNames& names = context.names;
  if (!names.actuators.contains(name.text) && names_load(name, one, context)) {
    return;
  }
  const auto body =
      std::ranges::find_if(context.description.bodies, [&](const BodyDescription& other) {
        return other.name.text == name.text && other.mass.has_value();
      });
  if (body != context.description.bodies.end() && !names.actuators.contains(name.text)) {
    context.found.error(
        "E0313",
        name.where,
        fmt::format("{} '{}', which is a body", role, name.text),
        fmt::format("name its weight, {}{}, or an actuator", kWeightPrefix, name.text));
    return;
  }
  names.check_actuator(name, role, context.found);
}

}  // namespace

void check_case_names(const SectionContext& context) {
  const DeclaredNames& names = context.names;
  Diagnostics& found = context.found;
  for (const CaseDescription& one : context.description.cases) {
    check_knowns(one.motions, context);
    check_knowns(one.actions, context);
    for (const Name& input : one.inputs) {
      check_end(input, "'input' names", one, context);
    }
    for (const Name& output : one.outputs) {
      check_end(output, "'output' names", one, context);
    }
  }
  for (const Name& branch : context.description.tree.value_or(std::vector<Name>{})) {
    names.couplings.check(branch, "the tree names", found);
  }
}

void check_reported_quantities(const MechanismDescription& description,
                               const Topology& topology,
                               Diagnostics& found) {
  if (description.motion) {
    // Of more parts they are columns of the motion.
    std::vector<Name> names = description.motion->report;
    std::erase_if(names, [](const Name& one) {
      return one.text.find('/') != std::string::npos || std::ranges::count(one.text, '.') > 1;
    });
    check_report_quantities(names, true, topology, found);
  }
  if (description.sweep) {
    // Names of more parts are figures of a motion, or have had their complaint.
    std::vector<Name> names = description.sweep->report;
    std::erase_if(names, [](const Name& one) {
      return motion_figure_of(one.text).has_value() || std::ranges::count(one.text, '.') > 1;
    });
    check_report_quantities(names, false, topology, found);
  }
}

}  // namespace kinestat
