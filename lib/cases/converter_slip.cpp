#include "cases/converter_slip.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kinematics/velocity.hpp"
#include "statics/friction_law.hpp"

namespace kinestat {

namespace {

// Between so many speed ratios one is looked for at which the torque fits.
constexpr int kIntervals = 48;
constexpr int kMostSteps = 100;

struct Range {
  double low = 0.0;
  double high = 1.0;
};

// Where the characteristic may have a value.
Range range_of(const ConverterLaw& law) {
  Range range;
  const auto* curve = !law.capacity.law                            ? &law.capacity
                      : law.torque_ratio && !law.torque_ratio->law ? &*law.torque_ratio
                                                                   : nullptr;
  return curve != nullptr ? Range{.low = curve->at.front(), .high = curve->at.back()} : range;
}

struct Turns {
  double pump = 0.0;
  double turbine = 0.0;
};

class SlipSearch {
 public:
  SlipSearch(const Mechanism& mechanism,
             const CoordinateBasis& motions,
             const Case& which,
             const CouplingFriction& friction,
             const std::function<CaseAnalysis(const Case&)>& solve)
      : mechanism_(mechanism),
        motions_(motions),
        which_(which),
        friction_(friction),
        solve_(solve),
        freedom_(mechanism.topology.coupling(friction.coupling).first_freedom) {}

  std::optional<ConverterSearch> run() {
    const std::optional<Turns> at_rest = turns(0.0);
    const std::optional<Turns> at_one = at_rest ? turns(1.0) : std::nullopt;
    if (!at_one) {
      return std::nullopt;
    }
    first_ = *at_rest;
    slope_ = {.pump = at_one->pump - first_.pump, .turbine = at_one->turbine - first_.turbine};
    for (const std::size_t action : candidates()) {
      dropped_ = action;
      if (std::optional<ConverterSearch> found = search()) {
        return found;
      }
    }
    return std::nullopt;
  }

 private:
  Primary slip(double rate) const {
    const FreedomLabel& freedom = mechanism_.topology.freedoms[static_cast<std::size_t>(freedom_)];
    return {.index = freedom_,
            .value = rate,
            .given = mechanism_.topology.coupling(friction_.coupling).name + "." + freedom.name,
            .where = which_.where};
  }

  // Everything is linear in the slip.
  std::optional<Turns> turns(double rate) const {
    std::vector<Primary> known = which_.motions;
    known.push_back(slip(rate));
    const KinematicSolution motion = solve_velocity(mechanism_, motions_, known);
    if (motion.status != SolveStatus::solved) {
      return std::nullopt;
    }
    const auto [pump, turbine] = converter_turns(mechanism_, motion, friction_);
    return Turns{.pump = pump, .turbine = turbine};
  }

  // Known actions that may follow from the converter: those of the inputs before others, and such
  // as have a known speed, too, before all.
  std::vector<std::size_t> candidates() const {
    const Topology& topology = mechanism_.topology;
    const auto rank = [&](std::size_t i) {
      const int index = which_.actions[i].index;
      const auto actuator = std::ranges::find(topology.actuators, index, &ActuatorTopology::action);
      if (actuator == topology.actuators.end()) {
        return 3;
      }
      const auto a = static_cast<int>(actuator - topology.actuators.begin());
      const bool moves = std::ranges::find(which_.motions, actuator->freedom, &Primary::index) !=
                         which_.motions.end();
      return moves ? 0 : std::ranges::count(which_.inputs, a) > 0 ? 1 : 2;
    };
    std::vector<std::size_t> list;
    for (std::size_t i = 0; i < which_.actions.size(); ++i) {
      if (!which_.actions[i].moves()) {
        list.push_back(i);
      }
    }
    std::ranges::stable_sort(list, {}, rank);
    return list;
  }

  // The case at a speed ratio; empty where no slip gives it.
  std::optional<Case> case_at(double ratio) const {
    const double below = slope_.turbine - ratio * slope_.pump;
    const double rate = (ratio * first_.pump - first_.turbine) / below;
    if (below == 0.0 || !std::isfinite(rate)) {
      return std::nullopt;
    }
    Case one = which_;
    one.motions.push_back(slip(rate));
    one.actions.erase(one.actions.begin() + static_cast<std::ptrdiff_t>(dropped_));
    return one;
  }

  // What the action that is dropped would have to be, less what it is.
  std::optional<double> difference(double ratio) const {
    const std::optional<Case> one = case_at(ratio);
    if (!one) {
      return std::nullopt;
    }
    const CaseAnalysis solved = solve_(*one);
    const Primary& given = which_.actions[dropped_];
    if (!solved.action || solved.action->magnitudes.empty()) {
      return std::nullopt;
    }
    const auto& found = solved.action->magnitudes[static_cast<std::size_t>(given.index)];
    return found ? std::optional(*found - given.value) : std::nullopt;
  }

  std::optional<ConverterSearch> search() const {
    const Range range = range_of(*friction_.converter);
    const Primary& given = which_.actions[dropped_];
    ConverterSearch result{.coupling = friction_.coupling, .action = given.index};
    std::optional<double> last;
    double from = range.low;
    for (int i = 0; i <= kIntervals; ++i) {
      const double ratio =
          i == kIntervals ? range.high : range.low + (range.high - range.low) * i / kIntervals;
      const std::optional<double> now = difference(ratio);
      if (now) {
        const double torque = *now + given.value;
        result.least = result.has_any ? std::min(result.least, torque) : torque;
        result.greatest = result.has_any ? std::max(result.greatest, torque) : torque;
        result.has_any = true;
      }
      if (now == 0.0) {
        result.ratios.push_back(ratio);
      } else if (now && last && *last != 0.0 && (*now < 0.0) != (*last < 0.0)) {
        result.ratios.push_back(root({from, ratio}, *last, *now));
      }
      last = now;
      from = ratio;
    }
    if (!result.has_any) {
      return std::nullopt;
    }
    if (result.ratios.size() == 1) {
      result.which = case_at(result.ratios.front());
    }
    return result;
  }

  // By false position with halved weights (Illinois), then halving: the ends have other signs.
  double root(Range ends, double low, double high) const {
    int side = 0;
    for (int i = 0; i < kMostSteps; ++i) {
      const double middle = 0.5 * (ends.low + ends.high);
      double ratio = i % 4 == 3 ? middle : (ends.low * high - ends.high * low) / (high - low);
      if (!(ratio > ends.low && ratio < ends.high)) {
        ratio = middle;
      }
      if (ratio <= ends.low || ratio >= ends.high) {
        break;  // neighbours
      }
      const std::optional<double> now = difference(ratio);
      if (!now || *now == 0.0) {
        return ratio;
      }
      if ((*now < 0.0) == (low < 0.0)) {
        ends.low = ratio;
        low = *now;
        high = side == -1 ? 0.5 * high : high;
        side = -1;
      } else {
        ends.high = ratio;
        high = *now;
        low = side == 1 ? 0.5 * low : low;
        side = 1;
      }
    }
    return 0.5 * (ends.low + ends.high);
  }

  const Mechanism& mechanism_;
  const CoordinateBasis& motions_;
  const Case& which_;
  const CouplingFriction& friction_;
  const std::function<CaseAnalysis(const Case&)>& solve_;
  int freedom_ = 0;
  std::size_t dropped_ = 0;
  Turns first_;  ///< without slip
  Turns slope_;  ///< per unit of it
};

}  // namespace

std::optional<ConverterSearch> find_converter_slip(
    const Mechanism& mechanism,
    const CoordinateBasis& motions,
    const Case& which,
    const std::function<CaseAnalysis(const Case&)>& solve) {
  for (const CouplingFriction& friction : mechanism.frictions) {
    if (friction.converter && !friction.converter->is_of_stator) {
      if (auto found = SlipSearch(mechanism, motions, which, friction, solve).run()) {
        return found;
      }
    }
  }
  return std::nullopt;
}

}  // namespace kinestat
