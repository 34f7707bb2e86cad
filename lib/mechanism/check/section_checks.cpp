#include "mechanism/check/section_checks.hpp"

#include <algorithm>

#include "mechanism/check/report_name_check.hpp"
#include "mechanism/gears/internal/losses.hpp"
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
      names.couplings.check(target, "a case knows something of", context.found);
    } else if (!is_declared) {
      names.check_actuator(target, "a case knows", context.found);
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
  check_sweep(context);
  check_synthesis(context);
}

void check_case_names(const SectionContext& context) {
  const DeclaredNames& names = context.names;
  Diagnostics& found = context.found;
  for (const CaseDescription& one : context.description.cases) {
    check_knowns(one.motions, context);
    check_knowns(one.actions, context);
    for (const Name& input : one.inputs) {
      names.check_actuator(input, "'input' names", found);
    }
    for (const Name& output : one.outputs) {
      names.check_actuator(output, "'output' names", found);
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
    check_report_quantities(description.motion->report, topology, found);
  }
  if (description.sweep) {
    // Names of more parts are figures of a motion, or have had their complaint.
    std::vector<Name> names = description.sweep->report;
    std::erase_if(names, [](const Name& one) {
      return motion_figure_of(one.text).has_value() || std::ranges::count(one.text, '.') > 1;
    });
    check_report_quantities(names, topology, found);
  }
}

}  // namespace kinestat
