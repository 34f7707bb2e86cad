#include <array>

#include <fmt/format.h>

#include "cases/picture/case_maps.hpp"
#include "cases/picture/lever_diagram.hpp"
#include "draw/catalogue/catalogue_parts.hpp"
#include "draw/gnuplot.hpp"
#include "studies/duty/picture/efficiency_picture.hpp"
#include "studies/shift/picture/ratio_ladder.hpp"

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

using MapOf = BarMap(const Analysis&);

template <MapOf map_of>
Picture drawn_bars(const PictureSource& source) {
  return draw_bar_map(map_of(chosen(source)));
}

template <MapOf map_of>
std::vector<Picture> bars_in_parts(const PictureSource& source) {
  return draw_bar_map_in_parts(map_of(chosen(source)));
}

template <MapOf map_of>
std::string plotted_bars(const PictureSource& source) {
  return gnuplot_text(map_of(chosen(source)));
}

std::string why_no_velocities(const PictureSource& source) {
  return why_not_in_cases(source, has_velocities, "velocities that are solved");
}

std::string why_no_actions(const PictureSource& source) {
  return why_not_in_cases(source, has_actions, "actions that are solved");
}

// Bars of nothing say nothing.
std::string why_no_speeds(const PictureSource& source) {
  const std::string why_not = why_no_velocities(source);
  return why_not.empty() && speed_map(chosen(source)).blocks.empty() ? "no body moves" : why_not;
}

std::string why_no_torques(const PictureSource& source) {
  const std::string why_not = why_no_actions(source);
  return why_not.empty() && torque_map(chosen(source)).blocks.empty() ? "no coupling bears a moment"
                                                                      : why_not;
}

std::string why_no_forces(const PictureSource& source) {
  const std::string why_not = why_no_actions(source);
  return why_not.empty() && force_map(chosen(source)).blocks.empty() ? "no coupling bears a force"
                                                                     : why_not;
}

std::string why_no_shift(const PictureSource& source) {
  return source.analysis->shift ? "" : "the file has no section 'shift'";
}

std::string why_no_ratios(const PictureSource& source) {
  const std::string why_not = why_no_shift(source);
  return why_not.empty() && !has_ratios(*source.analysis) ? "no gear has a ratio" : why_not;
}

std::vector<Lever> levers_of(const PictureSource& source) {
  const Mechanism& mechanism = source.analysis->mechanism;
  return find_levers(mechanism.topology, mechanism.geometry);
}

std::string why_no_levers(const PictureSource& source) {
  if (levers_of(source).empty()) {
    return "no two gears turn about the axis on which their carrier turns, so that no speeds lie "
           "on a lever";
  }
  return why_no_velocities(source);
}

// Those of the case that is asked for, or all.
std::vector<EfficiencyMap> maps_of(const PictureSource& source) {
  std::vector<EfficiencyMap> maps = *source.maps;
  if (source.which) {
    std::erase_if(maps, [&](const EfficiencyMap& map) { return map.which != *source.which; });
  }
  return maps;
}

std::string why_no_maps(const PictureSource& source) {
  if (!maps_of(source).empty()) {
    return "";
  }
  constexpr std::string_view kLack =
      "one input with a speed and a torque or force that are known and not zero";
  return source.which ? fmt::format("case '{}' is not in the duty, or has not {}",
                                    source.analysis->cases[*source.which].which.label,
                                    kLack)
                      : fmt::format("no case of a duty and no gear has {}", kLack);
}

Picture draw_maps(const PictureSource& source) {
  return draw_efficiency_maps(*source.analysis, maps_of(source));
}

Picture draw_levers(const PictureSource& source) {
  return draw_lever_diagram(chosen(source), levers_of(source));
}

std::vector<Picture> draw_each_lever(const PictureSource& source) {
  return draw_levers_in_parts(chosen(source), levers_of(source));
}

Picture draw_matrix(const PictureSource& source) {
  return draw_shift_matrix(*source.analysis);
}

Picture draw_ladder(const PictureSource& source) {
  return draw_ratio_ladder(*source.analysis);
}

constexpr auto kCaseKinds = std::to_array<PictureKind>({
    {.name = "speeds",
     .sentence = "bars of the velocities of all bodies, case by case",
     .why_not = why_no_speeds,
     .draw = drawn_bars<speed_map>,
     .draw_in_parts = bars_in_parts<speed_map>,
     .gnuplot = plotted_bars<speed_map>},
    {.name = "forces",
     .sentence = "bars of the forces in all couplings, case by case",
     .why_not = why_no_forces,
     .draw = drawn_bars<force_map>,
     .draw_in_parts = bars_in_parts<force_map>,
     .gnuplot = plotted_bars<force_map>},
    {.name = "torques",
     .sentence = "bars of the moments in all couplings, case by case",
     .why_not = why_no_torques,
     .draw = drawn_bars<torque_map>,
     .draw_in_parts = bars_in_parts<torque_map>,
     .gnuplot = plotted_bars<torque_map>},
    {.name = "lever",
     .sentence = "planetary sets as levers, with the speeds of each case",
     .why_not = why_no_levers,
     .draw = draw_levers,
     .draw_in_parts = draw_each_lever},
    {.name = "shift-matrix",
     .sentence = "which clutches and brakes each gear engages",
     .why_not = why_no_shift,
     .draw = draw_matrix},
    {.name = "ratio-ladder",
     .sentence = "the ratios of the gears and the steps between them",
     .why_not = why_no_ratios,
     .draw = draw_ladder},
    {.name = "efficiency-map",
     .sentence = "efficiency over speed and torque of the input, with the points of a duty",
     .need = PictureNeed::maps,
     .why_not = why_no_maps,
     .draw = draw_maps},
});

}  // namespace

std::span<const PictureKind> case_kinds() {
  return kCaseKinds;
}

}  // namespace kinestat
