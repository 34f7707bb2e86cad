#include "statics/cable_contact_state.hpp"

#include <algorithm>
#include <cmath>

#include "core/rounding.hpp"
#include "kinematics/bounded_motion.hpp"
#include "mechanism/cables/capstan.hpp"
#include "statics/coupling_wrenches.hpp"

namespace kinestat {

namespace {

std::optional<BoundedNumber> tension(const Mechanism& mechanism,
                                     CouplingId segment,
                                     const StaticSolution& solution) {
  const int action = mechanism.topology.coupling(segment).first_action;
  return solution.magnitudes[static_cast<std::size_t>(action)]
             ? std::optional(bounded_action(solution, action))
             : std::nullopt;
}

// The rate of the virtual link relative to the pulley; no slip without a virtual link.
BoundedNumber slip_speed(const Mechanism& mechanism,
                         const CableContact& contact,
                         const KinematicSolution& motion) {
  if (!contact.slips) {
    return {};
  }
  const CouplingTopology& coupling = mechanism.topology.coupling(*contact.slips);
  const double radius = contact.radius;
  return bounded_rate(motion, coupling.first_freedom) *
         BoundedNumber{.value = radius, .bound = kDataRounding * std::abs(radius)};
}

// With the rounding of the radii at which tensions pull: two that are equal as typed differ by it.
BoundedNumber rounded(BoundedNumber tension) {
  tension.bound += kDataRounding * std::abs(tension.value);
  return tension;
}

BeltState belt_state_of(const CableContactState& state) {
  if (state.slip_speed.value_or(0.0) != 0.0) {
    return BeltState::slipping;
  }
  if (!state.limit || !state.before || !state.after) {
    return BeltState::unknown;
  }
  const double high = std::max(*state.before, *state.after);
  const double low = std::min(*state.before, *state.after);
  if (high <= 0.0) {
    return BeltState::unknown;
  }
  return high <= *state.limit * low * (1.0 + kSameValue) ? BeltState::sticking
                                                         : BeltState::beyond_limit;
}

}  // namespace

std::vector<CableContactState> find_cable_contact_states(const Mechanism& mechanism,
                                                         const StaticSolution& solution,
                                                         const KinematicSolution* motion) {
  std::vector<CableContactState> states;
  if (solution.magnitudes.empty()) {
    return states;
  }
  for (const CableContact& contact : mechanism.contacts) {
    CableContactState state;
    const auto before = tension(mechanism, contact.arrives, solution);
    const auto after = tension(mechanism, contact.leaves, solution);
    state.before = before ? std::optional(before->zeroed()) : std::nullopt;
    state.after = after ? std::optional(after->zeroed()) : std::nullopt;
    if (state.before && state.after && *state.before > 0.0 && *state.after > 0.0) {
      const auto [low, high] = std::minmax(*state.before, *state.after);
      state.ratio = high / low;
    }
    if (contact.friction && contact.wrap) {
      state.limit = capstan_ratio(*contact.friction, *contact.wrap);
    }
    if (motion != nullptr) {
      const BoundedNumber speed = slip_speed(mechanism, contact, *motion);
      state.slip_speed = speed.zeroed();
      if (before && after) {
        state.slip_power = ((rounded(*before) - rounded(*after)) * speed).zeroed();
      }
    }
    state.belt_state = belt_state_of(state);
    states.push_back(state);
  }
  return states;
}

}  // namespace kinestat
