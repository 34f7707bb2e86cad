#include "studies/transmissions/ladder_figures.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "studies/transmissions/section_layout.hpp"

namespace kinestat {

namespace {

void raise(double& largest, const std::vector<double>& values) {
  for (const double value : values) {
    largest = std::max(largest, std::abs(value));
  }
}

std::uint32_t state_of(const TransmissionTrain& transmission, std::uint8_t engaged) {
  const GenericTrain& train = *transmission.train;
  ClassMask classes = 0;
  for (std::size_t j = 0; j < transmission.elements.size(); ++j) {
    if ((engaged >> j & 1U) != 0) {
      classes |= ClassMask{1} << train.class_of(transmission.elements[j]);
    }
  }
  return static_cast<std::uint32_t>(train.state_of(classes));
}

}  // namespace

std::vector<LadderGear> find_ladder_gears(const TransmissionTask& task,
                                          const TransmissionTrain& transmission,
                                          std::span<const std::uint8_t> ladder) {
  std::vector<double> losses;
  std::vector<double> planets;
  for (int s = 0; s < task.sets(); ++s) {
    const SetKind kind = transmission.roles.kind_of(s);
    losses.push_back(task.losses[static_cast<std::size_t>(kind)]);
    planets.push_back(sun_by_planet(
        kind, transmission.stationary_ratios[static_cast<std::size_t>(s)], task.teeth));
  }
  std::vector<std::uint32_t> states;
  std::vector<LadderGear> gears;
  for (std::size_t i = 0; i < ladder.size(); ++i) {
    LadderGear& gear = gears.emplace_back();
    const bool is_reverse = static_cast<int>(i) >= task.ladder.forward;
    gear.label = is_reverse ? "R" : fmt::format("{}", i + 1);
    gear.engaged = ladder[i];
    gear.figures = find_gear_figures(transmission, gear.engaged);
    for (std::size_t s = 0; s < planets.size(); ++s) {
      gear.planet_speeds.push_back(0.0 - gear.figures.rolling[s] * planets[s]);
    }
    states.push_back(state_of(transmission, gear.engaged));
  }
  const std::vector<GearLosses> lost = find_gear_losses(
      *transmission.train, transmission.roles, transmission.stationary_ratios, losses, states);
  for (std::size_t i = 0; i < gears.size(); ++i) {
    gears[i].efficiency = lost[i].efficiency;
  }
  return gears;
}

LadderFigures find_ladder_figures(const TransmissionTask& task,
                                  const TransmissionTrain& transmission,
                                  const std::vector<LadderGear>& gears) {
  LadderFigures figures{.least_efficiency = 1.0};
  std::vector<double> ratios;
  for (std::size_t i = 0; i < gears.size(); ++i) {
    const LadderGear& gear = gears[i];
    if (static_cast<int>(i) < task.ladder.forward) {
      ratios.push_back(gear.figures.ratio);
      figures.mean_efficiency += gear.efficiency / task.ladder.forward;
    }
    figures.least_efficiency = std::min(figures.least_efficiency, gear.efficiency);
    raise(figures.element_torque, gear.figures.torques);
    raise(figures.element_slip, gear.figures.slips);
    raise(figures.shaft_speed, gear.figures.speeds);
    raise(figures.planet_speed, gear.planet_speeds);
  }
  figures.spread = ratios.front() / ratios.back();
  figures.unevenness = unevenness(ratios);
  figures.rotating_clutches = static_cast<std::size_t>(std::ranges::count_if(
      transmission.elements, [](const ShaftPair& pair) { return pair[0] != kHousing; }));
  figures.hollow_shafts = least_hollow_shafts(
      transmission.train->structure(), transmission.roles, transmission.elements, task.layout);
  return figures;
}

double unevenness(std::span<const double> ratios) {
  const std::size_t steps = ratios.size() - 1;
  const double mean = std::log(ratios.front() / ratios.back()) / static_cast<double>(steps);
  double sum = 0.0;
  for (std::size_t i = 0; i < steps; ++i) {
    const double deviation = std::log(ratios[i] / ratios[i + 1]) - mean;
    sum += deviation * deviation;
  }
  return std::sqrt(sum / static_cast<double>(steps));
}

}  // namespace kinestat
