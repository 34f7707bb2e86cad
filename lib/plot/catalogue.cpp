#include "plot/catalogue.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "plot/case_maps.hpp"
#include "plot/gnuplot.hpp"
#include "plot/lever_diagram.hpp"
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

std::string lack_of_velocities(const PictureSource& source) {
  return any_case(source, has_velocities) ? "" : "no case has its velocities solved";
}

std::string lack_of_actions(const PictureSource& source) {
  return any_case(source, has_actions) ? "" : "no case has its actions solved";
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

std::string lack_of_times(const PictureSource& source) {
  return pareto_figure("", *source.benchmark).charts.empty()
             ? "no case has as many magnitudes known as its equations need"
             : "";
}

Figure pareto_of(const PictureSource& source) {
  return pareto_figure("Time against error of the methods of solution", *source.benchmark);
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

constexpr std::array<PictureKind, 7> kKinds = {{
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
    {.name = "pareto",
     .sentence = "time against error of the methods of solution",
     .need = PictureNeed::benchmark,
     .lack = lack_of_times,
     .draw = draw_pareto,
     .gnuplot = pareto_text},
}};

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
