#include "statics/contact_state.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

std::optional<double> tension(const Mechanism& mechanism,
                              CouplingId segment,
                              const StaticSolution& solution) {
  const int action = mechanism.topology.coupling(segment).first_action;
  return solution.magnitudes[static_cast<std::size_t>(action)];
}

// The rate of the virtual link relative to the pulley; no slip without a virtual link. What is
// rounding beside the fastest motion is none, as for friction.
double slip_speed(const Mechanism& mechanism,
                  const CableContact& contact,
                  const KinematicSolution& motion) {
  if (!contact.slips) {
    return 0.0;
  }
  const double length = mechanism.geometry.length;
  const CouplingTopology& coupling = mechanism.topology.coupling(*contact.slips);
  const double rate = motion.rates[static_cast<std::size_t>(coupling.first_freedom)];
  const bool is_rounding = std::abs(rate) * length <= kReportZero * fastest_motion(motion, length);
  return is_rounding ? 0.0 : rate * contact.radius;
}

Grip grip_of(const ContactState& state) {
  if (state.slip_speed.value_or(0.0) != 0.0) {
    return Grip::slips;
  }
  if (!state.limit || !state.before || !state.after) {
    return Grip::unknown;
  }
  const double high = std::max(*state.before, *state.after);
  const double low = std::min(*state.before, *state.after);
  if (high <= 0.0) {
    return Grip::unknown;
  }
  return high <= *state.limit * low * (1.0 + kSameValue) ? Grip::sticks : Grip::would_slip;
}

}  // namespace

std::vector<ContactState> find_contact_states(const Mechanism& mechanism,
                                              const StaticSolution& solution,
                                              const KinematicSolution* motion) {
  std::vector<ContactState> states;
  if (solution.magnitudes.empty()) {
    return states;
  }
  for (const CableContact& contact : mechanism.contacts) {
    ContactState state;
    state.before = tension(mechanism, contact.arrives, solution);
    state.after = tension(mechanism, contact.leaves, solution);
    if (state.before && state.after && *state.before > 0.0 && *state.after > 0.0) {
      const auto [low, high] = std::minmax(*state.before, *state.after);
      state.ratio = high / low;
    }
    if (contact.friction && contact.wrap) {
      state.limit = std::exp(*contact.friction * *contact.wrap);
    }
    if (motion != nullptr) {
      state.slip_speed = slip_speed(mechanism, contact, *motion);
      if (state.before && state.after) {
        state.slip_power = (*state.before - *state.after) * *state.slip_speed;
      }
    }
    state.grip = grip_of(state);
    states.push_back(state);
  }
  return states;
}

}  // namespace kinestat
