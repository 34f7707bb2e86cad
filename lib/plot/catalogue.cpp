#include "plot/catalogue.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "plot/burmester_drawing.hpp"
#include "plot/case_maps.hpp"
#include "plot/dot.hpp"
#include "plot/gear_scheme.hpp"
#include "plot/gnuplot.hpp"
#include "plot/graph_drawing.hpp"
#include "plot/lever_diagram.hpp"
#include "plot/linkage_drawing.hpp"
#include "plot/pareto.hpp"
#include "plot/picture_title.hpp"
#include "plot/ratio_ladder.hpp"
#include "plot/shift_matrix.hpp"

namespace kinestat {

namespace {

bool has_velocities(const CaseAnalysis& one) {
  return one.motion && one.motion->status == SolveStatus::solved;
}

bool has_actions(const CaseAnalysis& one) {
  return one.action && !one.action->wrenches.empty();
}

bool has_power(const CaseAnalysis& one) {
  return one.power.has_value();
}

// The analysis with the one case that is asked for, or all.
Analysis chosen(const PictureSource& source) {
  Analysis analysis = *source.analysis;
  if (source.which) {
    analysis.cases = {source.analysis->cases[*source.which]};
  }
  return analysis;
}

bool any_case(const PictureSource& source, bool (*counts)(const CaseAnalysis&)) {
  const std::vector<CaseAnalysis>& cases = source.analysis->cases;
  return source.which ? counts(cases[*source.which]) : std::ranges::any_of(cases, counts);
}

// Why no case that is asked for counts; `what` is "velocities that are solved".
std::string lack_in_cases(const PictureSource& source,
                          bool (*counts)(const CaseAnalysis&),
                          std::string_view what) {
  if (any_case(source, counts)) {
    return "";
  }
  return source.which
             ? fmt::format(
                   "case '{}' has no {}", source.analysis->cases[*source.which].which.label, what)
             : fmt::format("no case has {}", what);
}

std::string lack_of_velocities(const PictureSource& source) {
  return lack_in_cases(source, has_velocities, "velocities that are solved");
}

std::string lack_of_actions(const PictureSource& source) {
  return lack_in_cases(source, has_actions, "actions that are solved");
}

std::string lack_of_power(const PictureSource& source) {
  return lack_in_cases(source, has_power, "power, for which velocities and actions are needed");
}

std::string lack_of_nothing(const PictureSource&) {
  return "";
}

std::string lack_of_circuits(const PictureSource& source) {
  return circuit_models(*source.analysis).empty() ? "its graph has no circuit" : "";
}

std::string lack_of_shift(const PictureSource& source) {
  return source.analysis->shift ? "" : "the file has no section 'shift'";
}

std::string lack_of_ratios(const PictureSource& source) {
  const std::string lack = lack_of_shift(source);
  return lack.empty() && !has_ratios(*source.analysis) ? "no gear has a ratio" : lack;
}

std::vector<Lever> levers_of(const PictureSource& source) {
  const Mechanism& mechanism = source.analysis->mechanism;
  return find_levers(mechanism.topology, mechanism.geometry);
}

std::string lack_of_levers(const PictureSource& source) {
  if (levers_of(source).empty()) {
    return "no two gears turn about the axis on which their carrier turns, so that no speeds lie "
           "on a lever";
  }
  return lack_of_velocities(source);
}

std::string lack_of_gears(const PictureSource& source) {
  return has_gear_scheme(*source.analysis) ? "" : "no gears with parallel axes mesh";
}

std::string lack_of_task(const PictureSource& source) {
  return source.synthesis->tasks.empty() ? "no choice of the task is left" : "";
}

std::string lack_of_times(const PictureSource& source) {
  return pareto_figure("", *source.benchmark).charts.empty()
             ? "no case has as many magnitudes known as its equations need"
             : "";
}

// The case that is asked for, or the first that counts.
std::size_t case_of(const PictureSource& source, bool (*counts)(const CaseAnalysis&)) {
  const std::vector<CaseAnalysis>& cases = source.analysis->cases;
  return source.which
             ? *source.which
             : static_cast<std::size_t>(std::ranges::find_if(cases, counts) - cases.begin());
}

// Pictures are named as in the catalogue.
Picture named(std::string_view name, Picture picture) {
  picture.name = name;
  return picture;
}

Picture draw_mechanism(const PictureSource& source) {
  LinkageOptions options;
  if (!source.analysis->cases.empty()) {
    options.which = source.which.value_or(0);
  }
  return named("linkage", draw_linkage(*source.analysis, options));
}

Picture draw_scheme(const PictureSource& source) {
  return named("gear-scheme", *draw_gear_scheme(*source.analysis, {.which = source.which}));
}

Picture draw_plane(const PictureSource& source) {
  return draw_burmester(*source.synthesis, 0);
}

Picture draw_coupling_graph(const PictureSource& source) {
  return named("coupling-graph", draw_graph(coupling_graph_model(*source.analysis)));
}

Picture draw_motion_graph(const PictureSource& source) {
  return named("motion-graph", draw_graph(motion_graph_model(*source.analysis)));
}

Picture draw_action_graph(const PictureSource& source) {
  return named("action-graph", draw_graph(action_graph_model(*source.analysis)));
}

Picture draw_circuits(const PictureSource& source) {
  return named("circuits",
               *draw_graphs(circuit_models(*source.analysis),
                            picture_title("Fundamental circuits", *source.analysis)));
}

Picture draw_cutsets(const PictureSource& source) {
  return named("cut-sets",
               *draw_graphs(cutset_models(*source.analysis),
                            picture_title("Fundamental cut-sets", *source.analysis)));
}

GraphModel power_of(const PictureSource& source) {
  return power_model(*source.analysis, case_of(source, has_power));
}

Picture draw_power(const PictureSource& source) {
  return named("power-flow", draw_graph(power_of(source)));
}

std::string coupling_graph_text(const PictureSource& source) {
  return dot_text(coupling_graph_model(*source.analysis));
}

std::string motion_graph_text(const PictureSource& source) {
  return dot_text(motion_graph_model(*source.analysis));
}

std::string action_graph_text(const PictureSource& source) {
  return dot_text(action_graph_model(*source.analysis));
}

std::string power_text(const PictureSource& source) {
  return dot_text(power_of(source));
}

// Of solutions that do not know what they are of.
std::string titled(std::string_view what, const PictureSource& source) {
  return source.name.empty() ? std::string(what) : fmt::format("{}: {}", what, source.name);
}

Figure pareto_of(const PictureSource& source) {
  return pareto_figure(titled("Time against error of the methods", source), *source.benchmark);
}

Picture draw_speeds(const PictureSource& source) {
  return draw_bar_map(speed_map(chosen(source)));
}

Picture draw_torques(const PictureSource& source) {
  return draw_bar_map(torque_map(chosen(source)));
}

Picture draw_forces(const PictureSource& source) {
  return draw_bar_map(force_map(chosen(source)));
}

Picture draw_levers(const PictureSource& source) {
  return draw_lever_diagram(chosen(source), levers_of(source));
}

Picture draw_matrix(const PictureSource& source) {
  return draw_shift_matrix(*source.analysis);
}

Picture draw_ladder(const PictureSource& source) {
  return draw_ratio_ladder(*source.analysis);
}

Picture draw_pareto(const PictureSource& source) {
  return draw_figure(pareto_of(source));
}

std::string speeds_text(const PictureSource& source) {
  return gnuplot_text(speed_map(chosen(source)));
}

std::string torques_text(const PictureSource& source) {
  return gnuplot_text(torque_map(chosen(source)));
}

std::string forces_text(const PictureSource& source) {
  return gnuplot_text(force_map(chosen(source)));
}

std::string pareto_text(const PictureSource& source) {
  return gnuplot_text(pareto_of(source));
}

constexpr auto kKinds = std::to_array<PictureKind>({
    {.name = "linkage",
     .sentence = "the mechanism to scale, with the forces of a case",
     .scope = PictureScope::one_case,
     .lack = lack_of_nothing,
     .draw = draw_mechanism},
    {.name = "gear-scheme",
     .sentence = "a gear train along its axis, with its clutches and brakes",
     .scope = PictureScope::one_case,
     .lack = lack_of_gears,
     .draw = draw_scheme},
    {.name = "coupling-graph",
     .sentence = "bodies and couplings as a graph, with its tree",
     .lack = lack_of_nothing,
     .draw = draw_coupling_graph,
     .dot = coupling_graph_text},
    {.name = "motion-graph",
     .sentence = "the graph with a line for each freedom",
     .lack = lack_of_nothing,
     .draw = draw_motion_graph,
     .dot = motion_graph_text},
    {.name = "action-graph",
     .sentence = "the graph with a line for each constraint",
     .lack = lack_of_nothing,
     .draw = draw_action_graph,
     .dot = action_graph_text},
    {.name = "circuits",
     .sentence = "the fundamental circuits in the graph",
     .lack = lack_of_circuits,
     .draw = draw_circuits},
    {.name = "cut-sets",
     .sentence = "the fundamental cut-sets in the graph",
     .lack = lack_of_nothing,
     .draw = draw_cutsets},
    {.name = "power-flow",
     .sentence = "where the power of a case goes, by its size",
     .scope = PictureScope::one_case,
     .lack = lack_of_power,
     .draw = draw_power,
     .dot = power_text},
    {.name = "speeds",
     .sentence = "bars of the velocities of all bodies, case by case",
     .lack = lack_of_velocities,
     .draw = draw_speeds,
     .gnuplot = speeds_text},
    {.name = "torques",
     .sentence = "bars of the moments in all couplings, case by case",
     .lack = lack_of_actions,
     .draw = draw_torques,
     .gnuplot = torques_text},
    {.name = "forces",
     .sentence = "bars of the forces in all couplings, case by case",
     .lack = lack_of_actions,
     .draw = draw_forces,
     .gnuplot = forces_text},
    {.name = "lever",
     .sentence = "planetary sets as levers, with the speeds of each case",
     .lack = lack_of_levers,
     .draw = draw_levers},
    {.name = "shift-matrix",
     .sentence = "which clutches and brakes each gear engages",
     .lack = lack_of_shift,
     .draw = draw_matrix},
    {.name = "ratio-ladder",
     .sentence = "the ratios of the gears and the steps between them",
     .lack = lack_of_ratios,
     .draw = draw_ladder},
    {.name = "burmester",
     .sentence = "the positions of a synthesis with poles, curves and dyads",
     .need = PictureNeed::synthesis,
     .lack = lack_of_task,
     .draw = draw_plane},
    {.name = "pareto",
     .sentence = "time against error of the methods of solution",
     .need = PictureNeed::benchmark,
     .lack = lack_of_times,
     .draw = draw_pareto,
     .gnuplot = pareto_text},
});

bool has_need(PictureNeed need, const PictureSource& source) {
  switch (need) {
    case PictureNeed::analysis:
      return source.analysis != nullptr;
    case PictureNeed::synthesis:
      return source.synthesis != nullptr;
    case PictureNeed::benchmark:
      return source.benchmark != nullptr;
    case PictureNeed::motion:
      return false;
  }
  return false;
}

}  // namespace

std::span<const PictureKind> picture_kinds() {
  return kKinds;
}

const PictureKind* find_picture_kind(std::string_view name) {
  const auto at = std::ranges::find(kKinds, name, &PictureKind::name);
  return at == kKinds.end() ? nullptr : &*at;
}

bool has_picture(const PictureKind& kind, const PictureSource& source) {
  return has_need(kind.need, source) && kind.lack(source).empty();
}

}  // namespace kinestat
