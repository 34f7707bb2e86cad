#include "studies/transmissions/gear_figures.hpp"

#include <algorithm>
#include <cstddef>

namespace kinestat {

namespace {

using JoinedShafts = std::vector<ShaftPair>;

// The motion that is left while shafts are joined, of any size; all zero if none of the sets' is.
std::vector<double> motion_of(const TransmissionTrain& transmission,
                              const std::vector<double>& minors,
                              const JoinedShafts& joined) {
  const TransmissionStructure& structure = transmission.train->structure();
  std::vector<double> speeds(static_cast<std::size_t>(structure.shafts));
  const auto merged = MergedShafts::merge(structure.shafts, joined);
  if (!merged) {
    return speeds;
  }
  for (std::size_t shaft = 0; shaft < speeds.size(); ++shaft) {
    const auto terms =
        transmission.train->minors().speed_terms(*merged, merged->of(static_cast<Shaft>(shaft)));
    speeds[shaft] = SetMinors::sum<double>(terms, minors);
  }
  return speeds;
}

double slip(const std::vector<double>& speeds, const ShaftPair& pair) {
  return speeds[pair[1]] - speeds[pair[0]];
}

}  // namespace

GearFigures find_gear_figures(const TransmissionTrain& transmission, std::uint8_t engaged) {
  const GenericTrain& train = *transmission.train;
  std::vector<SetEquation<double>> equations;
  for (int s = 0; s < train.structure().set_count(); ++s) {
    equations.push_back(set_equation(
        transmission.roles, s, transmission.stationary_ratios[static_cast<std::size_t>(s)]));
  }
  std::vector<double> minors(train.minors().count());
  train.minors().evaluate<double>(equations, minors);
  JoinedShafts joined;
  const std::size_t count = transmission.elements.size();
  for (std::size_t j = 0; j < count; ++j) {
    if ((engaged >> j & 1U) != 0) {
      joined.push_back(transmission.elements[j]);
    }
  }
  GearFigures figures;
  figures.speeds = motion_of(transmission, minors, joined);
  const double input = figures.speeds[kInput];
  figures.ratio = input / figures.speeds[kOutput];
  for (double& speed : figures.speeds) {
    speed /= input;
  }
  // An element bears what lets no power pass while the output is held and it slips alone.
  std::size_t place = 0;
  for (std::size_t j = 0; j < count; ++j) {
    const ShaftPair& element = transmission.elements[j];
    figures.slips.push_back(slip(figures.speeds, element));
    figures.torques.push_back(0.0);
    if ((engaged >> j & 1U) != 0) {
      JoinedShafts others = joined;
      others[place++] = {kHousing, kOutput};
      const std::vector<double> speeds = motion_of(transmission, minors, others);
      figures.slips.back() = 0.0;
      figures.torques.back() = -speeds[kInput] / slip(speeds, element);
    }
  }
  return figures;
}

std::vector<GearLosses> find_gear_losses(const GenericTrain& train,
                                         const RoleChoice& roles,
                                         const StationaryPoint& point,
                                         std::span<const double> set_losses,
                                         std::span<const std::uint32_t> states) {
  constexpr double kStep = 1.25;  // any: speeds are affine
  const auto sets = static_cast<std::size_t>(train.structure().set_count());
  // The point, and for each set one in which its ratio alone is another.
  std::array<StationaryPoint, kRatioLanes> points;
  points.fill(point);
  StationaryBox box{.from = point, .to = point};
  for (std::size_t s = 0; s < sets; ++s) {
    points[s + 1][s] *= kStep;
    const double left = 1.0 - set_losses[s];
    box.from[s] *= left;
    box.to[s] /= left;
  }
  RatioTable table(train);
  table.set_points(roles, points);
  std::vector<SpeedLanes> speeds(states.size());
  table.speeds(states, speeds);
  table.set_corners(roles, box);
  std::vector<RatioLanes> corners(states.size() * table.blocks());
  table.ratios(states, corners);
  std::vector<GearLosses> losses(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto& input = speeds[i].input.at;
    const auto& output = speeds[i].output.at;
    std::size_t corner = 0;
    for (std::size_t s = 0; s < sets; ++s) {
      const double rolling =
          ((input[s + 1] / input[0] - 1.0) - (output[s + 1] / output[0] - 1.0)) / (kStep - 1.0);
      losses[i].rolling[s] = rolling;
      corner |= rolling < 0.0 ? std::size_t{1} << s : 0;
    }
    const double with_losses =
        corners[i * table.blocks() + corner / kRatioLanes].at[corner % kRatioLanes];
    losses[i].efficiency = with_losses / (input[0] / output[0]);
  }
  return losses;
}

}  // namespace kinestat
