#include "mechanism/bind/bind.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "couplings/kinds.hpp"
#include "description/cable_expansion.hpp"
#include "description/gear_expansion.hpp"
#include "mechanism/bind/judged_numbers.hpp"
#include "mechanism/bind/structure_binder.hpp"
#include "mechanism/cables/internal/cable_check.hpp"
#include "mechanism/cables/internal/cable_contact_binder.hpp"
#include "mechanism/cases/case_binder.hpp"
#include "mechanism/cases/load_binder.hpp"
#include "mechanism/check/geometry_check.hpp"
#include "mechanism/check/section_checks.hpp"
#include "mechanism/couplings/drawn_coupling_binder.hpp"
#include "mechanism/couplings/internal/compliance_binder.hpp"
#include "mechanism/curves/curve_binder.hpp"
#include "mechanism/curves/moving_number_binder.hpp"
#include "mechanism/gears/internal/gear_binder.hpp"
#include "mechanism/gears/internal/gear_check.hpp"
#include "mechanism/gears/internal/mesh_loss_binder.hpp"
#include "mechanism/gears/internal/planet_set.hpp"
#include "mechanism/gears/planet_load.hpp"
#include "mechanism/inertia/mass_binder.hpp"
#include "mechanism/springs/spring_binder.hpp"
#include "mechanism/unanalysed.hpp"

namespace kinestat {

namespace {

// Whether a twist or a wrench has more than wz, vx, vy or Tz, Fx, Fy.
template <class Screw>
bool leaves_plane(const Screw& screw) {
  const Vec6 c = screw.coordinates();
  return c[0] != 0.0 || c[1] != 0.0 || c[5] != 0.0;
}

void refuse_planar_order(const MechanismDescription& description,
                         std::string_view what,
                         Diagnostics& found) {
  found.error("E0305",
              description.order_where,
              fmt::format("the planar order cannot hold {}", what),
              "write minimal or spatial");
}

// A planar order must hold every screw of its side.
void check_order(const MechanismDescription& description,
                 const Mechanism& mechanism,
                 Diagnostics& found) {
  const Geometry& geometry = mechanism.geometry;
  if (mechanism.kinematic_order == OrderChoice::planar &&
      std::ranges::any_of(geometry.motions, leaves_plane<Twist>)) {
    refuse_planar_order(description, "the motions of this mechanism", found);
  }
  if (mechanism.static_order == OrderChoice::planar &&
      std::ranges::any_of(geometry.actions, leaves_plane<Wrench>)) {
    refuse_planar_order(description, "the actions of this mechanism", found);
  }
}

// Whatever the curves that it follows are.
bool may_leave_plane(const MovingLoad& load) {
  const auto acts = [](const MovingNumber& one) { return one.law != nullptr || one.value != 0.0; };
  const bool is_in_plane = !load.point || load.point->z() == 0.0;
  return acts(load.force[2]) || acts(load.couple[0]) || acts(load.couple[1]) ||
         (!is_in_plane && std::ranges::any_of(load.force, acts));
}

void check_order_of_loads(const MechanismDescription& description,
                          const std::vector<Case>& cases,
                          Diagnostics& found) {
  if (description.static_order != OrderChoice::planar) {
    return;
  }
  for (const Case& one : cases) {
    for (const Load& load : one.loads) {
      if (leaves_plane(load.acts.wrench)) {
        refuse_planar_order(description, fmt::format("load '{}'", load.name), found);
        return;
      }
    }
    for (const MovingLoad& load : one.moving_loads) {
      if (may_leave_plane(load)) {
        refuse_planar_order(description, fmt::format("load '{}'", load.name), found);
        return;
      }
    }
  }
}

bool bind_structure(const MechanismDescription& description,
                    ScrewSpaces spaces,
                    Evaluator& evaluator,
                    Diagnostics& found,
                    Mechanism& result) {
  result.name = description.name;
  result.space = description.space;
  result.kinematic_order = description.kinematic_order;
  result.static_order = description.static_order;
  result.indeterminate = description.indeterminate;
  bind_bodies_and_couplings(description, spaces, evaluator, found, result);
  return !found.has_errors();  // those of the parameters too: their couplings are left out
}

bool bind_graph(const MechanismDescription& description, Diagnostics& found, Mechanism& result) {
  const int errors_before = found.error_count();
  check_order(description, result, found);
  std::optional<CouplingGraph> graph = bind_coupling_graph(description, result.topology, found);
  if (graph) {
    result.graph = *std::move(graph);
  }
  return found.error_count() == errors_before;
}

// Whether all couplings have their screws, so that freedoms and actions have names.
bool has_all_screws(const MechanismDescription& description) {
  return has_all_meshes(description) && is_expanded(description) &&
         std::ranges::all_of(description.couplings, [](const CouplingDescription& coupling) {
           return !is_counted_only(coupling);
         });
}

// A mechanism some of whose couplings have no screws yet cannot name its freedoms and actions, so
// of its cases only values and the names before the dots are checked.
void check_cases(const MechanismDescription& description, Evaluator& evaluator) {
  for (const CaseDescription& one : description.cases) {
    for (const auto* side : {&one.motions, &one.actions}) {
      for (const Assignment& assignment : *side) {
        if (side == &one.motions || !names_curve(assignment.value, description)) {
          (void)evaluator.quantity(assignment.value);
        }
      }
    }
  }
}

// Whether errors of the analysis or only warnings come of what is not analysed.
enum class Purpose {
  analyse,
  close,  ///< what is not assembled will be closed
  check
};

void report_unanalysed(const std::vector<Unanalysed>& list, Purpose purpose, Diagnostics& found) {
  for (const Unanalysed& one : list) {
    std::string message = one.message();
    if (purpose == Purpose::close && one.is_closure_error) {
      continue;
    }
    if (one.decides && purpose != Purpose::check) {
      found.error(
          "E0315",
          one.where,
          std::move(message),
          !one.hint.empty() ? one.hint : "'kinestat help format' lists what this version analyses");
    } else {
      found.warning("W0302", one.where, std::move(message), one.hint);
    }
  }
}

// What the forces of inertia of its cases follow from. What 'dynamics' asks, such as a flywheel,
// machines without masses have too.
void bind_inertia(const SectionContext& context, Mechanism& result) {
  if (!context.description.dynamics && std::ranges::none_of(result.masses, &BodyMass::counts)) {
    const auto one = std::ranges::find_if(context.description.cases, &CaseDescription::has_inertia);
    context.found.warning(
        "W0312",
        one != context.description.cases.end() ? one->label.where
                                               : context.description.shift->where,
        "accelerations cause no forces, because no body has mass or inertia",
        fmt::format("give bodies 'mass', 'centre_of_mass' and 'inertia'{}",
                    // Of a motion they decide how fast it goes.
                    context.description.motion ? "" : ", or remove 'acceleration'"));
  }
  result.drawn_couplings = bind_drawn_couplings(context.description, result);
}

// Springs act in every case, as loads do.
void ask_for_actions(const Mechanism& mechanism, std::vector<Case>& cases) {
  for (Case& one : cases) {
    one.asks_actions = one.asks_actions || one.has_inertia() || !mechanism.springs.empty();
  }
}

// All sections beside the structure; the cases, where they are bound, get their loads.
void bind_sections(const SectionContext& context, bool has_structure, Mechanism& result) {
  const int errors_before = context.found.error_count();
  check_sections(context);
  const std::vector<DescribedMass> masses = bind_masses(context);
  std::vector<CaseLoads> loads = bind_loads(context, masses, result.curves);
  std::vector<Spring> springs =
      bind_springs(context, has_structure ? &result.topology : nullptr, result.curves);
  if (context.found.error_count() > errors_before || !has_structure) {
    return;
  }
  result.springs = std::move(springs);
  if (!masses.empty()) {
    result.masses = masses_of_bodies(context, result, masses);
    place_gear_weights(context, result.masses, loads);
  }
  add_loads(std::move(loads), result.cases);
  bind_load_ends(context, result.cases);
  check_order_of_loads(context.description, result.cases, context.found);
  const auto& shift = context.description.shift;
  if (std::ranges::any_of(result.cases, &Case::has_inertia) || (shift && shift->has_inertia())) {
    bind_inertia(context, result);
  }
  ask_for_actions(result, result.cases);
}

// Numbers of gears that are made of a parameter without a value have no complaint of their own.
bool has_gear_numbers(const SectionContext& context) {
  return !context.description.gears || !has_all_meshes(context.description) ||
         bind_gear_frame<double>(context.description, context.evaluator).has_value();
}

// The couplings that gears and cables make are bound only if these are right, so that each mistake
// has one complaint.
bool bind_whole_structure(const SectionContext& context, ScrewSpaces spaces, Mechanism& result) {
  const MechanismDescription& description = context.description;
  const bool has_right_gears = check_gears(context) && has_gear_numbers(context);
  const bool has_right_cables = description.cables.empty() || check_cables(context);
  if (has_right_gears && has_right_cables) {
    return bind_structure(description, spaces, context.evaluator, context.found, result);
  }
  MechanismDescription rest = has_right_cables ? description : without_cable_parts(description);
  if (!has_right_gears) {
    rest = without_meshes(rest);
  }
  (void)bind_structure(rest, spaces, context.evaluator, context.found, result);
  return false;
}

std::optional<Mechanism> bind_for(Purpose purpose,
                                  const MechanismDescription& description,
                                  Diagnostics& found,
                                  JudgedNumbers* judged = nullptr) {
  const int errors_before = found.error_count();
  const std::vector<Unanalysed> unanalysed = find_unanalysed(description);
  const bool is_undecided = std::ranges::any_of(unanalysed, [purpose](const Unanalysed& one) {
    return one.decides && !(purpose == Purpose::close && one.is_closure_error);
  });
  Evaluator evaluator = make_evaluator(description, found);
  const DeclaredNames names = declare_names(description, found);
  const SectionContext context = {.description = description,
                                  .names = names,
                                  .evaluator = evaluator,
                                  .found = found,
                                  .checked = judged == nullptr ? nullptr : &judged->by_rule};
  if (judged != nullptr) {
    evaluator.note_numbers(&judged->by_more);
  }
  Mechanism result;
  bool has_structure = false;
  const ScrewSpaces spaces = {.motions = description.space,
                              .actions = description.static_order == OrderChoice::spatial
                                             ? Space::spatial
                                             : description.space};
  if (description.has_mechanism()) {
    const bool is_good = bind_whole_structure(context, spaces, result);
    const bool has_names = is_good && has_all_screws(description);
    result.curves = bind_curves(context, has_names ? &result.topology : nullptr);
    if (!has_names) {
      check_cases(description, evaluator);
      check_case_names(context);
    } else if (bind_graph(description, found, result)) {
      has_structure = true;
      result.cases = bind_cases(description, result.topology, result.curves, evaluator, found);
      result.planet_counts = bind_planet_counts(description, result.topology, evaluator);
      result.load_sharing = bind_load_sharing(description, result.topology, evaluator);
      result.compliances = bind_compliances(description, result.topology, evaluator);
      bind_contacts(description, evaluator, found, result);
      result.freewheels = bind_freewheels(description, result.topology);
      check_reported_quantities(description, result.topology, found);
    }
  } else {
    (void)check_gears(context);
  }
  bind_sections(context, has_structure, result);
  if (has_structure && has_planets(result)) {
    settle_planet_frictions(result, found);
  }
  if (found.error_count() == errors_before && description.losses) {
    result.lossy_meshes = bind_losses(description, evaluator, found);
    result.loss_model = description.losses->model;
  }
  if (found.error_count() == errors_before) {
    evaluator.warn_of_unused();
    warn_of_unused_curves(description, found);
    warn_of_idle_stiffness(description, found);
    if (description.motion) {  // at rest, coaxial bearings are as good as any
      warn_of_links_without_length(description, result, found);
    }
    report_unanalysed(unanalysed, purpose, found);
  }
  const bool is_right = found.error_count() == errors_before;
  KINESTAT_EXPECTS(!is_right || is_undecided ||
                   (has_all_meshes(description) && is_expanded(description)));
  return is_right && description.has_mechanism() && !is_undecided ? std::optional(std::move(result))
                                                                  : std::nullopt;
}

}  // namespace

std::optional<Mechanism> bind(const MechanismDescription& description, Diagnostics& found) {
  return bind_for(Purpose::analyse, description, found);
}

std::optional<Mechanism> bind_unassembled(const MechanismDescription& description,
                                          Diagnostics& found) {
  return bind_for(Purpose::close, description, found);
}

bool check(const MechanismDescription& description, Diagnostics& found) {
  const int errors_before = found.error_count();
  (void)bind_for(Purpose::check, description, found);
  return found.error_count() == errors_before;
}

JudgedNumbers find_judged_numbers(const MechanismDescription& description) {
  JudgedNumbers judged;
  Diagnostics found;
  (void)bind_for(Purpose::check, description, found, &judged);
  return judged;
}

std::optional<Mechanism> bind_in_space(const MechanismDescription& description,
                                       Diagnostics& found) {
  const int errors_before = found.error_count();
  Evaluator evaluator = make_evaluator(description, found);
  Mechanism result;
  if (bind_structure(description, ScrewSpaces{}, evaluator, found, result)) {
    // A planar order is that of the screws in the plane; in space, they may be more.
    for (OrderChoice* const order : {&result.kinematic_order, &result.static_order}) {
      *order = *order == OrderChoice::planar ? OrderChoice::minimal : *order;
    }
    bind_graph(description, found, result);
  }
  return found.error_count() == errors_before ? std::optional(std::move(result)) : std::nullopt;
}

bool frees_more_in_space(const MechanismDescription& description) {
  return description.space == Space::planar &&
         std::ranges::any_of(description.couplings, [](const CouplingDescription& coupling) {
           return kind_of(coupling.type).frees_more_in_space || coupling.contact ||
                  !coupling.constraints.empty();
         });
}

}  // namespace kinestat
