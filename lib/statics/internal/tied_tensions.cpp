#include "statics/internal/tied_tensions.hpp"

#include <algorithm>
#include <optional>

namespace kinestat {

namespace {

// A pulley on which a cable slips: the tension behind it is a share of the tension ahead.
struct SlippingPulley {
  const FrictionLaw* law = nullptr;
  int ahead = 0;        // action: the tension ahead
  int behind = 0;       // action: the tension behind
  double share = 0.0;   // of the tension ahead: the tension behind
  double radius = 0.0;  // [m] of the pulley, positive
};

std::vector<SlippingPulley> find_slipping_pulleys(const Mechanism& mechanism,
                                                  std::span<const Primary> primaries,
                                                  std::span<const FrictionLaw> laws) {
  const Topology& topology = mechanism.topology;
  std::vector<SlippingPulley> pulleys;
  for (const FrictionLaw& law : laws) {
    if (is_tied(mechanism, primaries, law)) {
      const PressingPart& part = law.parts.front();
      pulleys.push_back({.law = &law,
                         .ahead = topology.coupling(*part.of).first_action,
                         .behind = topology.coupling(*part.slack).first_action,
                         .share = part.slack_share,
                         .radius = part.weight / (1.0 - part.slack_share)});
    }
  }
  return pulleys;
}

// The friction on both bodies of the pulley, of 1 N at its rim.
std::vector<BodyWrench> pulls_of(const Topology& topology, const SlippingPulley& pulley) {
  const CouplingTopology& coupling = topology.coupling(pulley.law->coupling);
  const Wrench couple = pulley.radius * pulley.law->unit;
  return {{.body = coupling.head, .wrench = couple},
          {.body = coupling.tail, .wrench = -1.0 * couple}};
}

// Tensions as multiples of that of one segment, from pulley to pulley.
class TensionTree {
 public:
  TensionTree(const Topology& topology, const std::vector<SlippingPulley>& pulleys)
      : pulleys_(pulleys), shares_(topology.actions.size()), is_used_(pulleys.size(), false) {}

  bool has(int action) const { return shares_[static_cast<std::size_t>(action)].has_value(); }

  // All segments that cables join to the one of which the tension is 1; false if they go in
  // circles.
  bool grow(int root, const Topology& topology, std::vector<TiedTension>& ties) {
    shares_[static_cast<std::size_t>(root)] = 1.0;
    for (bool goes_on = true; goes_on;) {
      goes_on = false;
      for (std::size_t i = 0; i < pulleys_.size(); ++i) {
        const SlippingPulley& pulley = pulleys_[i];
        if (is_used_[i] || (!has(pulley.ahead) && !has(pulley.behind))) {
          continue;
        }
        if (has(pulley.ahead) && has(pulley.behind)) {
          return false;
        }
        is_used_[i] = true;
        goes_on = true;
        ties.push_back(tie(root, pulley, topology));
      }
    }
    return true;
  }

 private:
  TiedTension tie(int root, const SlippingPulley& pulley, const Topology& topology) {
    std::optional<double>& ahead = shares_[static_cast<std::size_t>(pulley.ahead)];
    std::optional<double>& behind = shares_[static_cast<std::size_t>(pulley.behind)];
    const bool is_behind = ahead.has_value();
    if (is_behind) {
      behind = *ahead * pulley.share;
    } else {
      ahead = *behind / pulley.share;
    }
    return {.action = is_behind ? pulley.behind : pulley.ahead,
            .to = root,
            .share = is_behind ? *behind : *ahead,
            .friction_share = *ahead * (1.0 - pulley.share),
            .pulls = pulls_of(topology, pulley)};
  }

  const std::vector<SlippingPulley>& pulleys_;
  std::vector<std::optional<double>> shares_;  // by action
  std::vector<bool> is_used_;
};

// Whether the action is the tension of a segment at an end of the cable, not between two pulleys.
bool is_end(int action, TiedTo to, const std::vector<SlippingPulley>& pulleys) {
  const auto other = to == TiedTo::least ? &SlippingPulley::ahead : &SlippingPulley::behind;
  return std::ranges::find(pulleys, action, other) == pulleys.end();
}

}  // namespace

bool is_tied(const Mechanism& mechanism,
             std::span<const Primary> primaries,
             const FrictionLaw& law) {
  const bool is_cable_alone =
      law.parts.size() == 1 && law.parts.front().slack.has_value() && law.constant == 0.0;
  if (!is_cable_alone) {
    return false;
  }
  // A link of the cable alone turns there, and no body of the file.
  const bool slips = std::ranges::any_of(mechanism.contacts, [&](const CableContact& contact) {
    return contact.slips == law.coupling;
  });
  const Topology& topology = mechanism.topology;
  const bool is_held =
      std::ranges::any_of(topology.actuators, [&](const ActuatorTopology& actuator) {
        const auto freedom = static_cast<std::size_t>(actuator.freedom);
        return topology.freedoms[freedom].coupling == law.coupling &&
               std::ranges::none_of(primaries, [&](const Primary& known) {
                 return known.index == actuator.action && known.value == 0.0;
               });
      });
  return slips && !is_held;
}

std::vector<TiedTension> find_ties(const Mechanism& mechanism,
                                   std::span<const Primary> primaries,
                                   std::span<const FrictionLaw> laws,
                                   TiedTo to) {
  const Topology& topology = mechanism.topology;
  const std::vector<SlippingPulley> pulleys = find_slipping_pulleys(mechanism, primaries, laws);
  std::vector<int> roots;
  for (const Primary& primary : primaries) {
    roots.push_back(primary.index);
  }
  const std::size_t known = roots.size();
  for (const SlippingPulley& pulley : pulleys) {
    roots.push_back(to == TiedTo::least ? pulley.behind : pulley.ahead);
  }
  TensionTree tree(topology, pulleys);
  std::vector<TiedTension> ties;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const bool is_known = i < known;
    if (!is_known && (tree.has(roots[i]) || !is_end(roots[i], to, pulleys))) {
      continue;
    }
    if (tree.has(roots[i]) || !tree.grow(roots[i], topology, ties)) {
      return {};
    }
  }
  return std::ssize(ties) == std::ssize(pulleys) ? ties : std::vector<TiedTension>{};
}

}  // namespace kinestat
