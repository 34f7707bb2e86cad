// Where cables and contacts no longer hold what they hold, which ends a simulation.
#include <algorithm>
#include <cmath>

#include "core/index.hpp"
#include "core/motion_tolerance.hpp"
#include "core/tolerance.hpp"
#include "mechanism/cables/capstan.hpp"
#include "studies/motion/configuration.hpp"
#include "studies/simulation/internal/simulator.hpp"

namespace kinestat {

std::vector<Happening> Simulator::possible_partings() const {
  using enum SimulationEvent::Kind;
  std::vector<Happening> all;
  for (std::size_t i = 0; i < one_sided_.size(); ++i) {
    const CouplingId id = topology_.actions[at(one_sided_[i])].coupling;
    all.push_back(
        {.kind = topology_.coupling(id).bears_tension() ? cable_slack : contact_pulls, .index = i});
  }
  for (std::size_t i = 0; i < network_.arcs.size(); ++i) {
    all.push_back({.kind = lift_off, .index = i});
  }
  for (std::size_t i = 0; i < mechanism_.contacts.size(); ++i) {
    if (mechanism_.contacts[i].friction && !mechanism_.contacts[i].slips) {
      all.push_back({.kind = cable_slips, .index = i});
    }
  }
  return all;
}

std::optional<double> Simulator::distance_to_parting(const Happening& what,
                                                     double time,
                                                     std::span<const double> y) {
  if (what.kind != SimulationEvent::Kind::lift_off) {
    return margin(what, borne_at(time, y));
  }
  Configuration there;
  return place(time, y, there)
             ? std::optional(contact_arcs(network_, there)[what.index] + kStraightArc)
             : std::nullopt;
}

std::optional<double> Simulator::margin(const Happening& what,
                                        const std::vector<std::optional<double>>& borne) const {
  double largest = 0.0;
  for (const std::optional<double>& one : borne) {
    largest = std::max(largest, std::abs(one.value_or(0.0)));
  }
  const double rounding = kConsistency * largest;
  if (what.kind != SimulationEvent::Kind::cable_slips) {
    const std::optional<double>& now = borne[at(one_sided_[what.index])];
    return now ? std::optional(*now + rounding) : std::nullopt;
  }
  const CableContact& contact = mechanism_.contacts[what.index];
  const auto& before = borne[at(topology_.coupling(contact.arrives).first_action)];
  const auto& behind = borne[at(topology_.coupling(contact.leaves).first_action)];
  if (!before || !behind || !contact.wrap) {
    return std::nullopt;
  }
  double wrap = *contact.wrap;
  for (std::size_t i = 0; i < network_.arcs.size(); ++i) {
    if (network_.arcs[i].contact == static_cast<int>(what.index)) {
      wrap = arcs_[i];
    }
  }
  const auto [low, high] = std::minmax(*before, *behind);
  return capstan_ratio(*contact.friction, wrap) * low - high + rounding;
}

// What nothing determines is told once.
const std::vector<std::optional<double>>& Simulator::borne_at(double time,
                                                              std::span<const double> y) {
  if (borne_at_ == time) {
    return borne_;
  }
  borne_.assign(topology_.actions.size(), std::nullopt);
  Configuration there;
  std::vector<double> accelerations(free_count());
  if (place(time, y, there) && accelerate(time, there, y, accelerations)) {
    borne_ = system_->tell(there, speeds_of(y), accelerations, true).borne;
    arcs_ = contact_arcs(network_, there);
    borne_at_ = time;
  }
  return borne_;
}

bool Simulator::look_at_once() {
  begins_anew_ = false;
  if (one_sided_.empty()) {
    return true;
  }
  borne_at_.reset();
  const std::vector<std::optional<double>>& borne = borne_at(time_, state_);
  if (!borne_at_) {
    return false;
  }
  for (const int action : one_sided_) {
    const CouplingId id = topology_.actions[at(action)].coupling;
    if (borne[at(action)]) {
      continue;
    }
    if (std::ranges::any_of(groups_, [](const StuckGroup& g) { return g.frictions.size() > 1; })) {
      obstacle_ = {.kind = SimulationObstacle::Kind::open_friction, .coupling = id};
      return false;
    }
    if (std::ranges::find(result_.unchecked, id) == result_.unchecked.end()) {
      result_.unchecked.push_back(id);
    }
  }
  for (const Happening& what : possible_partings()) {
    const std::optional<double> there = distance_to_parting(what, time_, state_);
    if (there && *there < 0.0) {
      end_by(what);
      break;
    }
  }
  return true;
}

// An impact may ask of a cable to push, or of surfaces to pull.
bool Simulator::parts_by(std::size_t stop, const ReducedSystem::Impulse& impulse, double change) {
  if (one_sided_.empty()) {
    return false;
  }
  const std::vector<std::optional<double>> borne =
      system_->borne_in(impulse, plan_.stops[stop].of.freedom, change);
  for (const Happening& what : possible_partings()) {
    if (what.kind == SimulationEvent::Kind::lift_off) {
      continue;
    }
    const std::optional<double> there = margin(what, borne);
    if (there && *there < 0.0) {
      end_by(what);
      return true;
    }
  }
  return false;
}

void Simulator::end_by(const Happening& what) {
  using enum SimulationEvent::Kind;
  std::string element;
  if (what.kind == lift_off || what.kind == cable_slips) {
    const int contact =
        what.kind == cable_slips ? static_cast<int>(what.index) : network_.arcs[what.index].contact;
    element = mechanism_.contacts[at(contact)].name;
  } else {
    const CouplingId id = topology_.actions[at(one_sided_[what.index])].coupling;
    element = topology_.coupling(id).name;
  }
  result_.events.push_back({.kind = what.kind, .time = time_, .element = std::move(element)});
  result_.end = SimulationEnd::parted;
}

}  // namespace kinestat
