#include "statics/internal/slipping_cable_tension.hpp"

#include <algorithm>
#include <optional>

namespace kinestat {

namespace {

// One cable on one pulley: the tension behind is a share of that ahead.
struct SlippingRope {
  const FrictionLaw* law = nullptr;
  int ahead = 0;
  int behind = 0;
  double share = 0.0;
  double radius = 0.0;  // [m] of the pulley, positive
};

std::vector<SlippingRope> find_ropes(const Mechanism& mechanism,
                                     std::span<const FrictionLaw> laws) {
  const Topology& topology = mechanism.topology;
  std::vector<SlippingRope> cables;
  for (const FrictionLaw& law : laws) {
    if (is_tied(mechanism, law)) {
      const PressingPart& part = law.parts.front();
      cables.push_back({.law = &law,
                        .ahead = topology.coupling(*part.of).first_action,
                        .behind = topology.coupling(*part.slack).first_action,
                        .share = part.slack_share,
                        .radius = part.weight / (1.0 - part.slack_share)});
    }
  }
  return cables;
}

// The friction on both bodies of the pulley, of 1 N at its rim.
std::vector<BodyWrench> pulls_of(const Topology& topology, const SlippingRope& cable) {
  const CouplingTopology& coupling = topology.coupling(cable.law->coupling);
  const Wrench couple = cable.radius * cable.law->unit;
  return {{.body = coupling.head, .wrench = couple},
          {.body = coupling.tail, .wrench = -1.0 * couple}};
}

// Tensions as multiples of that of one segment, from pulley to pulley.
class TensionTree {
 public:
  TensionTree(const Topology& topology, const std::vector<SlippingRope>& cables)
      : ropes_(cables), shares_(topology.actions.size()), is_used_(cables.size(), false) {}

  bool has(int action) const { return shares_[static_cast<std::size_t>(action)].has_value(); }

  // All segments that cables join to the one of which the tension is 1; false if they go in
  // circles.
  bool grow(int root, const Topology& topology, std::vector<SlippingCableTension>& ties) {
    shares_[static_cast<std::size_t>(root)] = 1.0;
    for (bool goes_on = true; goes_on;) {
      goes_on = false;
      for (std::size_t i = 0; i < ropes_.size(); ++i) {
        const SlippingRope& cable = ropes_[i];
        if (is_used_[i] || (!has(cable.ahead) && !has(cable.behind))) {
          continue;
        }
        if (has(cable.ahead) && has(cable.behind)) {
          return false;
        }
        is_used_[i] = true;
        goes_on = true;
        ties.push_back(tie(root, cable, topology));
      }
    }
    return true;
  }

 private:
  SlippingCableTension tie(int root, const SlippingRope& cable, const Topology& topology) {
    std::optional<double>& ahead = shares_[static_cast<std::size_t>(cable.ahead)];
    std::optional<double>& behind = shares_[static_cast<std::size_t>(cable.behind)];
    const bool is_behind = ahead.has_value();
    if (is_behind) {
      behind = *ahead * cable.share;
    } else {
      ahead = *behind / cable.share;
    }
    return {.action = is_behind ? cable.behind : cable.ahead,
            .to = root,
            .share = is_behind ? *behind : *ahead,
            .friction_share = *ahead * (1.0 - cable.share),
            .pulls = pulls_of(topology, cable)};
  }

  const std::vector<SlippingRope>& ropes_;
  std::vector<std::optional<double>> shares_;  // by action
  std::vector<bool> is_used_;
};

// Not between two pulleys.
bool is_end(int action, TiedTo to, const std::vector<SlippingRope>& cables) {
  const auto other = to == TiedTo::least ? &SlippingRope::ahead : &SlippingRope::behind;
  return std::ranges::find(cables, action, other) == cables.end();
}

}  // namespace

bool is_tied(const Mechanism& mechanism, const FrictionLaw& law) {
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
  const bool is_driven =
      std::ranges::any_of(topology.actuators, [&](const ActuatorTopology& actuator) {
        const auto freedom = static_cast<std::size_t>(actuator.freedom);
        return topology.freedoms[freedom].coupling == law.coupling;
      });
  return slips && !is_driven;
}

std::vector<SlippingCableTension> find_ties(const Mechanism& mechanism,
                                            std::span<const Primary> primaries,
                                            std::span<const FrictionLaw> laws,
                                            TiedTo to) {
  const Topology& topology = mechanism.topology;
  const std::vector<SlippingRope> cables = find_ropes(mechanism, laws);
  std::vector<int> roots;
  for (const Primary& primary : primaries) {
    roots.push_back(primary.index);
  }
  const std::size_t known = roots.size();
  for (const SlippingRope& cable : cables) {
    roots.push_back(to == TiedTo::least ? cable.behind : cable.ahead);
  }
  TensionTree tree(topology, cables);
  std::vector<SlippingCableTension> ties;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const bool is_known = i < known;
    if (!is_known && (tree.has(roots[i]) || !is_end(roots[i], to, cables))) {
      continue;
    }
    if (tree.has(roots[i]) || !tree.grow(roots[i], topology, ties)) {
      return {};
    }
  }
  return std::ssize(ties) == std::ssize(cables) ? ties : std::vector<SlippingCableTension>{};
}

}  // namespace kinestat
