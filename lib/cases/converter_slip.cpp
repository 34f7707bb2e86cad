#include "cases/converter_slip.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/rounding.hpp"
#include "kinematics/velocity.hpp"
#include "mechanism/couplings/speed_ratio_scan.hpp"
#include "statics/friction_law.hpp"

namespace kinestat {

namespace {

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
    const std::optional<double> at_rest = pump_speed(0.0);
    const std::optional<double> at_one = at_rest ? pump_speed(1.0) : std::nullopt;
    if (!at_one) {
      return std::nullopt;
    }
    first_ = *at_rest;
    slope_ = *at_one - first_;
    for (const std::size_t action : deciding_actions(mechanism_.topology, which_)) {
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
            .where = which_.where,
            .relative_bound = kSolvedRounding};
  }

  // The speed of the pump at a rate of the slip, in which it is linear. High accuracy, because the
  // speed of the turbine is the difference of this speed and the slip.
  std::optional<double> pump_speed(double rate) const {
    std::vector<Primary> known = which_.motions;
    known.push_back(slip(rate));
    const KinematicSolution motion =
        solve_velocity(mechanism_, motions_, known, {.accuracy = Accuracy::high});
    if (motion.status != SolveStatus::solved) {
      return std::nullopt;
    }
    return converter_turns(mechanism_, motion, friction_).pump;
  }

  // The case at a speed ratio; empty where no slip gives it. Turbine and pump differ by the slip,
  // which is zero without rounding where they turn alike.
  std::optional<Case> case_at(double ratio) const {
    const double rate = (ratio - 1.0) * first_ / (1.0 - (ratio - 1.0) * slope_);
    if (!std::isfinite(rate)) {
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
    return found ? std::optional(torque_miss(*found, given.value)) : std::nullopt;
  }

  std::optional<ConverterSearch> search() const {
    const SpeedRatioScan scan(*friction_.converter);
    const auto at = [&](double ratio) { return difference(ratio); };
    FittingRatios found =
        scan.run([&](std::size_t node) { return difference(scan.nodes()[node]); }, at);
    if (!found.has_any) {
      return std::nullopt;
    }
    const Primary& given = which_.actions[dropped_];
    ConverterSearch result{.coupling = friction_.coupling,
                           .action = given.index,
                           .least = found.least + given.value,
                           .greatest = found.greatest + given.value,
                           .ratios = std::move(found.ratios)};
    if (result.ratios.size() == 1) {
      result.which = case_at(result.ratios.front());
    }
    return result;
  }

  const Mechanism& mechanism_;
  const CoordinateBasis& motions_;
  const Case& which_;
  const CouplingFriction& friction_;
  const std::function<CaseAnalysis(const Case&)>& solve_;
  int freedom_ = 0;
  std::size_t dropped_ = 0;
  double first_ = 0.0;  ///< speed of the pump without slip
  double slope_ = 0.0;  ///< per unit of it
};

}  // namespace

std::vector<std::size_t> deciding_actions(const Topology& topology, const Case& which) {
  enum class Rank { of_known_motion, of_input, of_other_actuator, of_no_actuator };
  const auto rank = [&](std::size_t i) {
    const int index = which.actions[i].index;
    const auto actuator = std::ranges::find(topology.actuators, index, &ActuatorTopology::action);
    if (actuator == topology.actuators.end()) {
      return Rank::of_no_actuator;
    }
    const auto a = static_cast<int>(actuator - topology.actuators.begin());
    const bool moves =
        std::ranges::find(which.motions, actuator->freedom, &Primary::index) != which.motions.end();
    return moves                                     ? Rank::of_known_motion
           : std::ranges::count(which.inputs, a) > 0 ? Rank::of_input
                                                     : Rank::of_other_actuator;
  };
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < which.actions.size(); ++i) {
    if (!which.actions[i].moves()) {
      list.push_back(i);
    }
  }
  std::ranges::stable_sort(list, {}, rank);
  return list;
}

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
