#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "draw/catalogue/catalogue_parts.hpp"
#include "draw/gnuplot.hpp"
#include "draw/text_styles.hpp"
#include "studies/benchmark/picture/pareto.hpp"
#include "studies/motion/picture/actuator_curves.hpp"
#include "studies/motion/picture/dynamics_curves.hpp"
#include "studies/motion/picture/motion_curves.hpp"
#include "studies/simulation/picture/simulation_curves.hpp"
#include "studies/sweep/picture/sweep_curves.hpp"
#include "studies/synthesis/picture/best_linkages.hpp"
#include "studies/synthesis/picture/burmester_drawing.hpp"
#include "studies/transmissions/picture/ladders.hpp"

namespace kinestat {

namespace {

// Of solutions that do not know what they are of.
std::string titled(std::string_view what, const PictureSource& source) {
  return source.name.empty() ? std::string(what) : fmt::format("{}: {}", what, source.name);
}

using FigureOf = Figure(const PictureSource&);

template <FigureOf figure_of>
Picture drawn_figure(const PictureSource& source) {
  return draw_figure(figure_of(source));
}

template <FigureOf figure_of>
std::string plotted_figure(const PictureSource& source) {
  return gnuplot_text(figure_of(source));
}

std::string why_no_task(const PictureSource& source) {
  return source.synthesis->limits.function ? "a function has no positions of a plane to draw"
         : source.synthesis->tasks.empty() ? "no choice of the task is left"
                                           : "";
}

std::string why_no_times(const PictureSource& source) {
  return pareto_figure("", *source.benchmark).charts.empty()
             ? "no case has as many magnitudes known as its equations need"
             : "";
}

Picture draw_plane(const PictureSource& source) {
  return draw_burmester(*source.synthesis, 0);
}

std::vector<Picture> draw_small_plane(const PictureSource& source) {
  constexpr double kOfNumbers = 75.0;  // at its axis, with margins [px]
  return {draw_burmester(*source.synthesis, 0, kShrinking - kOfNumbers)};
}

std::string why_no_linkages(const PictureSource& source) {
  return find_best_linkages(*source.synthesis).empty() ? "the task has no linkage" : "";
}

Picture draw_linkages(const PictureSource& source) {
  return draw_best_linkages(*source.synthesis);
}

std::string why_no_ladders(const PictureSource& source) {
  return source.transmissions->groups.empty() ? "no transmission meets the requirements" : "";
}

Picture draw_found_ladders(const PictureSource& source) {
  return draw_ladders(*source.transmissions);
}

std::vector<Picture> draw_narrow_ladders(const PictureSource& source) {
  return {draw_ladders(*source.transmissions, LadderForm::narrow)};
}

Figure trade_offs_of(const PictureSource& source) {
  return trade_off_figure(*source.transmissions);
}

std::string why_no_animation(const PictureSource& source) {
  return source.moving->motion.positions.size() < 2 ? "its motion has no two positions" : "";
}

Picture draw_moving(const PictureSource& source) {
  return draw_animation(*source.moving, *source.motion);
}

Figure motion_of(const PictureSource& source) {
  return motion_figure(*source.motion, titled("Motion", source), source.over);
}

Figure paths_of(const PictureSource& source) {
  return path_figure(*source.motion, titled("Paths of points", source));
}

std::string why_no_curves(const PictureSource& source) {
  return motion_of(source).charts.empty()
             ? "its motion has no positions, or nothing changes but drives and paths"
             : "";
}

std::string why_no_paths(const PictureSource& source) {
  return paths_of(source).charts.empty()
             ? "in its motion no traced point moves: add 'trace' to 'motion'"
             : "";
}

Figure shaking_of(const PictureSource& source) {
  return shaking_figure(*source.motion, titled("Shaking force", source));
}

std::string why_no_shaking(const PictureSource& source) {
  return shaking_of(source).charts.empty() ? "its motion reports no shaking force: add 'report: "
                                             "dynamics' to 'motion', or 'balance' to 'dynamics'"
                                           : "";
}

Figure harmonics_of(const PictureSource& source) {
  return harmonic_figure(*source.motion, titled("Harmonics", source));
}

std::string why_no_harmonics(const PictureSource& source) {
  return harmonics_of(source).charts.empty()
             ? "its motion has no harmonics: add 'harmonics: 6' to 'dynamics'"
             : "";
}

Figure actuators_of(const PictureSource& source) {
  return actuator_figure(*source.motion, titled("Actions of actuators", source));
}

std::string why_no_actuators(const PictureSource& source) {
  return actuators_of(source).charts.empty()
             ? "it has no figures of actuators: add 'actuators: [NAME]' to 'dynamics'"
             : "";
}

Figure speed_torque_of(const PictureSource& source) {
  return speed_torque_figure(*source.motion, titled("Action over speed", source));
}

Figure simulation_of(const PictureSource& source) {
  return simulation_figure(*source.simulation, titled("Simulation", source));
}

std::string why_not_over_time(const PictureSource& source,
                              const Figure& figure,
                              const char* without_charts) {
  return source.simulation->rows.size() < 2 ? "its simulation has no two rows"
         : figure.charts.empty()            ? without_charts
                                            : "";
}

std::string why_no_simulation(const PictureSource& source) {
  return why_not_over_time(source, simulation_of(source), "nothing changes in its simulation");
}

Figure energies_of(const PictureSource& source) {
  return energy_figure(*source.simulation, titled("Energies", source));
}

std::string why_no_energies(const PictureSource& source) {
  return why_not_over_time(source, energies_of(source), "its simulation has no energies");
}

Figure sweep_of(const PictureSource& source) {
  return sweep_figure(*source.sweep, titled("Sweep", source));
}

std::string why_no_sweep(const PictureSource& source) {
  return why_no_curves_of_sweep(*source.sweep);
}

Figure pareto_of(const PictureSource& source) {
  return pareto_figure(titled("Time against error of the methods", source), *source.benchmark);
}

constexpr auto kStudyKinds = std::to_array<PictureKind>({
    {.name = "animation",
     .sentence = "the mechanism to scale, going through its motion by itself",
     .need = PictureNeed::moving,
     .why_not = why_no_animation,
     .draw = draw_moving},
    {.name = "motion-curves",
     .sentence = "positions, velocities and more of a motion over its drive or time",
     .need = PictureNeed::motion,
     .takes_abscissa = true,
     .why_not = why_no_curves,
     .draw = drawn_figure<motion_of>,
     .gnuplot = plotted_figure<motion_of>},
    {.name = "paths",
     .sentence = "the paths of points in a motion, to scale",
     .need = PictureNeed::motion,
     .why_not = why_no_paths,
     .draw = drawn_figure<paths_of>,
     .gnuplot = plotted_figure<paths_of>},
    {.name = "shaking",
     .sentence = "the shaking force on the frame, without and with counterweights",
     .need = PictureNeed::motion,
     .why_not = why_no_shaking,
     .draw = drawn_figure<shaking_of>,
     .gnuplot = plotted_figure<shaking_of>},
    {.name = "harmonics",
     .sentence = "amplitudes of torques, shaking and ground forces over their orders",
     .need = PictureNeed::motion,
     .why_not = why_no_harmonics,
     .draw = drawn_figure<harmonics_of>,
     .gnuplot = plotted_figure<harmonics_of>},
    {.name = "drive-torque",
     .sentence = "required torque or force of each actuator in a motion, with mean and RMS",
     .need = PictureNeed::motion,
     .why_not = why_no_actuators,
     .draw = drawn_figure<actuators_of>,
     .gnuplot = plotted_figure<actuators_of>},
    {.name = "speed-torque",
     .sentence = "required torque or force of each actuator over its own speed",
     .need = PictureNeed::motion,
     .why_not = why_no_actuators,
     .draw = drawn_figure<speed_torque_of>,
     .gnuplot = plotted_figure<speed_torque_of>},
    {.name = "simulation",
     .sentence = "positions, speeds and more of a simulation over time",
     .need = PictureNeed::simulation,
     .why_not = why_no_simulation,
     .draw = drawn_figure<simulation_of>,
     .gnuplot = plotted_figure<simulation_of>},
    {.name = "energies",
     .sentence = "energies of a simulation over time",
     .need = PictureNeed::simulation,
     .why_not = why_no_energies,
     .draw = drawn_figure<energies_of>,
     .gnuplot = plotted_figure<energies_of>},
    {.name = "sweep-curves",
     .sentence = "quantities of a sweep over a parameter",
     .need = PictureNeed::sweep,
     .why_not = why_no_sweep,
     .draw = drawn_figure<sweep_of>,
     .gnuplot = plotted_figure<sweep_of>},
    {.name = "synthesis",
     .sentence = "the best linkages of a synthesis, each through its positions",
     .need = PictureNeed::synthesis,
     .why_not = why_no_linkages,
     .draw = draw_linkages},
    {.name = "burmester",
     .sentence = "the positions of a synthesis with poles, curves and dyads",
     .need = PictureNeed::synthesis,
     .why_not = why_no_task,
     .draw = draw_plane,
     .draw_in_parts = draw_small_plane},
    {.name = "ladders",
     .sentence = "the ladders of gears that a search for transmissions has found",
     .need = PictureNeed::transmissions,
     .why_not = why_no_ladders,
     .draw = draw_found_ladders,
     .draw_in_parts = draw_narrow_ladders},
    {.name = "trade-offs",
     .sentence = "torque, speed and steps of transmissions over their efficiency",
     .need = PictureNeed::transmissions,
     .why_not = why_no_ladders,
     .draw = drawn_figure<trade_offs_of>,
     .gnuplot = plotted_figure<trade_offs_of>},
    {.name = "pareto",
     .sentence = "of the program: time against error of its methods of solution",
     .need = PictureNeed::benchmark,
     .why_not = why_no_times,
     .draw = drawn_figure<pareto_of>,
     .gnuplot = plotted_figure<pareto_of>},
});

}  // namespace

std::span<const PictureKind> study_kinds() {
  return kStudyKinds;
}

}  // namespace kinestat
