#include "studies/transmissions/gear_figures.hpp"

#include <algorithm>
#include <cstddef>

#include "core/tolerance.hpp"
#include "math/numbers/bounded_number.hpp"

namespace kinestat {

namespace {

using JoinedShafts = std::vector<ShaftPair>;

// A number with its bound as SetMinors takes numbers.
struct Bounded {
  Bounded() = default;

  explicit Bounded(double exact) : number{.value = exact, .bound = 0.0} {}

  explicit Bounded(const BoundedNumber& with_bound) : number(with_bound) {}

  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    return Bounded(a.number + b.number);
  }

  friend Bounded operator-(const Bounded& a, const Bounded& b) {
    return Bounded(a.number - b.number);
  }

  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    return Bounded(a.number * b.number);
  }

  BoundedNumber number;
};

// The minors of the sets. A stationary ratio, and what is made of it, is rounded.
std::vector<Bounded> minors_of(const TransmissionTrain& transmission) {
  const GenericTrain& train = *transmission.train;
  std::vector<SetEquation<Bounded>> equations;
  for (int s = 0; s < train.structure().set_count(); ++s) {
    const double ratio = transmission.stationary_ratios[static_cast<std::size_t>(s)];
    const SetEquation<double> rounded = set_equation(transmission.roles, s, ratio);
    const std::uint8_t sun = set_roles(transmission.roles.roles_of(s)).sun;
    const auto bounded = [&](std::uint8_t place) {
      return Bounded(BoundedNumber{.value = rounded[place],
                                   .bound = place == sun ? 0.0 : kEpsilon * (ratio + 1.0)});
    };
    equations.push_back({bounded(0), bounded(1), bounded(2)});
  }
  std::vector<Bounded> minors(train.minors().count(), Bounded(0.0));
  train.minors().evaluate<Bounded>(equations, minors);
  return minors;
}

// The motion that is left while shafts are joined, of any size; all zero if none of the sets' is.
std::vector<BoundedNumber> motion_of(const TransmissionTrain& transmission,
                                     const std::vector<Bounded>& minors,
                                     const JoinedShafts& joined) {
  const TransmissionStructure& structure = transmission.train->structure();
  std::vector<BoundedNumber> speeds(static_cast<std::size_t>(structure.shafts));
  const auto merged = MergedShafts::merge(structure.shafts, joined);
  if (!merged) {
    return speeds;
  }
  for (std::size_t shaft = 0; shaft < speeds.size(); ++shaft) {
    const auto terms =
        transmission.train->minors().speed_terms(*merged, merged->of(static_cast<Shaft>(shaft)));
    speeds[shaft] = SetMinors::sum<Bounded>(terms, minors).number;
  }
  return speeds;
}

// By a number that is known to be none; a zero has no sign.
double quotient(const BoundedNumber& number, double divisor) {
  return number.zeroed() / divisor + 0.0;
}

// Of the head against the tail.
BoundedNumber slip(const std::vector<BoundedNumber>& speeds, const ShaftPair& pair) {
  return speeds[pair[1]] - speeds[pair[0]];
}

}  // namespace

GearFigures find_gear_figures(const TransmissionTrain& transmission, std::uint8_t engaged) {
  const TransmissionStructure& structure = transmission.train->structure();
  const std::vector<Bounded> minors = minors_of(transmission);
  JoinedShafts joined;
  const std::size_t count = transmission.elements.size();
  for (std::size_t j = 0; j < count; ++j) {
    if ((engaged >> j & 1U) != 0) {
      joined.push_back(transmission.elements[j]);
    }
  }
  GearFigures figures;
  const std::vector<BoundedNumber> motion = motion_of(transmission, minors, joined);
  const double input = motion[kInput].value;
  const bool is_direct = slip(motion, {kInput, kOutput}).zeroed() == 0.0;
  figures.ratio = is_direct ? 1.0 : input / motion[kOutput].value;
  for (const BoundedNumber& speed : motion) {
    figures.speeds.push_back(quotient(speed, input));
  }
  for (int s = 0; s < structure.set_count(); ++s) {
    const SetShafts& shafts = structure.sets[static_cast<std::size_t>(s)];
    const SetRoles roles = set_roles(transmission.roles.roles_of(s));
    figures.rolling.push_back(slip(motion, {shafts[roles.carrier], shafts[roles.sun]}).zeroed() /
                              input);
  }
  // An element bears what lets no power pass while the output is held and it slips alone.
  std::size_t place = 0;
  for (std::size_t j = 0; j < count; ++j) {
    const ShaftPair& element = transmission.elements[j];
    const bool is_engaged = (engaged >> j & 1U) != 0;
    figures.slips.push_back(is_engaged ? 0.0 : quotient(slip(motion, element), input));
    figures.torques.push_back(0.0);
    if (is_engaged) {
      JoinedShafts others = joined;
      others[place++] = {kHousing, kOutput};
      const std::vector<BoundedNumber> held = motion_of(transmission, minors, others);
      figures.torques.back() = quotient(held[kInput], -slip(held, element).value);
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
    losses[i].efficiency = std::min(1.0, with_losses / (input[0] / output[0]));
  }
  return losses;
}

}  // namespace kinestat
