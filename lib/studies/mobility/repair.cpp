#include "studies/mobility/repair.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "core/tolerance.hpp"
#include "couplings/coupling_upgrade.hpp"
#include "math/elimination/elimination.hpp"
#include "network/bases.hpp"
#include "network/node_system.hpp"

namespace kinestat {

namespace {

// Costs are in arbitrary units: a changed coupling is what an engineer would rather avoid.
constexpr int kCostOfChange = 10;
constexpr int kCostOfTurn = 1;  // one cross instead of a ball or a sleeve
constexpr int kCostOfRareType = 12;
constexpr int kCostOfOwnType = 40;  // a freedom that no coupling of the catalogue adds
constexpr int kCostOfLeavingOut = 60;
constexpr int kCostOfActuated = 30;

// Beyond this many sets to look at, the search takes the best change at each step.
constexpr std::size_t kMostSets = 20000;
constexpr std::size_t kMostChanges = 3;

constexpr int kFreedomsInSpace = 6;

struct Candidate {
  CouplingChange change;
  MatX powers;  ///< of each self-stress on each added freedom, about 1
  int cost = 0;
};

// Columns that are independent of each other, as an orthonormal basis.
class Independence {
 public:
  explicit Independence(Eigen::Index size) : basis_(size, 0) {}

  Eigen::Index count() const { return basis_.cols(); }

  // Adds all columns, or none if they depend on what is there.
  bool add(const MatX& columns) {
    MatX extended = basis_;
    for (Eigen::Index c = 0; c < columns.cols(); ++c) {
      VecX rest = columns.col(c);
      const double size = rest.norm();
      for (int twice = 0; twice < 2; ++twice) {
        const VecX along = extended.transpose() * rest;
        rest -= extended * along;
      }
      if (rest.norm() <= kWorkingFreedom * size || size <= kWorkingFreedom) {
        return false;
      }
      extended.conservativeResize(Eigen::NoChange, extended.cols() + 1);
      extended.col(extended.cols() - 1) = rest.normalized();
    }
    basis_ = std::move(extended);
    return true;
  }

 private:
  MatX basis_;
};

class ChangeSearch {
 public:
  ChangeSearch(const Mechanism& mechanism, const std::vector<RedundantConstraint>& constraints)
      : mechanism_(mechanism),
        constraints_(constraints),
        size_(static_cast<Eigen::Index>(constraints.size())) {
    add_catalogue();
  }

  std::vector<std::vector<CouplingChange>> run(int most) {
    std::vector<Found> found;
    if (is_small()) {
      std::vector<std::size_t> chosen;
      explore(0, Independence(size_), 0, chosen, found);
    }
    if (found.empty()) {
      take_best(found);
    }
    std::ranges::stable_sort(found, {}, &Found::cost);
    std::vector<std::vector<CouplingChange>> sets;
    for (const Found& one : found) {
      if (sets.size() < static_cast<std::size_t>(most)) {
        sets.push_back(changes_of(one));
      }
    }
    return sets;
  }

 private:
  struct Found {
    int cost = 0;
    std::vector<std::size_t> chosen;  ///< candidates
  };

  void add_catalogue() {
    const Topology& topology = mechanism_.topology;
    for (const ActuatorTopology& actuator : topology.actuators) {
      actuated_.insert(topology.freedoms[static_cast<std::size_t>(actuator.freedom)].coupling);
    }
    for (int e = 0; e < topology.coupling_count(); ++e) {
      const CouplingTopology& coupling = topology.coupling({e});
      const std::span<const Twist> motions(mechanism_.geometry.motions);
      const auto freedoms = motions.subspan(static_cast<std::size_t>(coupling.first_freedom),
                                            static_cast<std::size_t>(coupling.freedom_count));
      const int base = kCostOfChange + (actuated_.contains({e}) ? kCostOfActuated : 0);
      for (const CouplingUpgrade& upgrade : coupling_upgrades(coupling.type, freedoms, at(e))) {
        const int rarity = upgrade.is_rare                         ? kCostOfRareType
                           : upgrade.to == CouplingType::universal ? kCostOfTurn
                                                                   : 0;
        add({.coupling = {e}, .to = upgrade.to, .is_left_out = false, .added = upgrade.added},
            base + rarity);
      }
      if (!actuated_.contains({e}) && coupling.freedom_count < kFreedomsInSpace) {
        add({.coupling = {e},
             .to = std::nullopt,
             .is_left_out = true,
             .added = prevented(e, freedoms)},
            kCostOfLeavingOut);
      }
    }
  }

  // Turns and shifts along the world axes that, with its own freedoms, leave a coupling nothing to
  // bear.
  std::vector<Twist> prevented(int e, std::span<const Twist> freedoms) const {
    const auto scaled = [&](const Twist& twist) {
      Vec6 column;
      column << twist.angular * mechanism_.geometry.length, velocity_at(twist, at(e));
      return Vec6(column.normalized());
    };
    Independence all(kFreedomsInSpace);
    for (const Twist& freedom : freedoms) {
      all.add(scaled(freedom));
    }
    std::vector<Twist> added;
    for (int i = 0; i < 3; ++i) {
      for (const Twist& twist :
           {unit_rotation(Vec3::Unit(i), at(e)), unit_translation(Vec3(Vec3::Unit(i)))}) {
        if (all.add(scaled(twist))) {
          added.push_back(twist);
        }
      }
    }
    return added;
  }

  Vec3 at(int e) const { return mechanism_.geometry.points[static_cast<std::size_t>(e)]; }

  void add(CouplingChange change, int cost) {
    MatX powers(size_, static_cast<Eigen::Index>(change.added.size()));
    for (std::size_t i = 0; i < change.added.size(); ++i) {
      powers.col(static_cast<Eigen::Index>(i)) = powers_of(change.coupling, change.added[i]);
    }
    if (Independence(size_).add(powers)) {
      candidates_.push_back({.change = std::move(change), .powers = powers, .cost = cost});
    }
  }

  // With the largest wrench of each self-stress as 1 and lengths in that of the mechanism.
  VecX powers_of(CouplingId coupling, const Twist& freedom) const {
    const double length = mechanism_.geometry.length;
    const double unit = freedom.angular.isZero(0.0) ? 1.0 : 1.0 / length;
    VecX powers(size_);
    for (Eigen::Index s = 0; s < size_; ++s) {
      const std::vector<Wrench>& wrenches = constraints_[static_cast<std::size_t>(s)].wrenches;
      double largest = 0.0;
      for (const Wrench& wrench : wrenches) {
        largest = std::max({largest, wrench.force.norm(), wrench.moment.norm() / length});
      }
      powers[s] =
          power(wrenches[static_cast<std::size_t>(coupling.value)], freedom) * unit / largest;
    }
    return powers;
  }

  bool is_small() const {
    std::size_t sets = 1;
    for (std::size_t i = 0; i < kMostChanges && sets <= kMostSets; ++i) {
      sets *= candidates_.size();
    }
    return sets <= kMostSets;
  }

  // At most one change a coupling, in the order of the couplings.
  void explore(std::size_t from,
               const Independence& so_far,
               int cost,
               std::vector<std::size_t>& chosen,
               std::vector<Found>& found) const {
    if (so_far.count() == size_) {
      found.push_back({.cost = cost, .chosen = chosen});
      return;
    }
    if (chosen.size() == kMostChanges) {
      return;
    }
    for (std::size_t c = from; c < candidates_.size(); ++c) {
      const CouplingId coupling = candidates_[c].change.coupling;
      Independence next = so_far;
      if (next.add(candidates_[c].powers)) {
        std::size_t after = c + 1;
        while (after < candidates_.size() && candidates_[after].change.coupling == coupling) {
          ++after;
        }
        chosen.push_back(c);
        explore(after, next, cost + candidates_[c].cost, chosen, found);
        chosen.pop_back();
      }
    }
  }

  // The cheapest for each redundancy that it removes, one after the other; what the catalogue
  // cannot remove goes by single freedoms.
  void take_best(std::vector<Found>& found) {
    Found one;
    Independence so_far(size_);
    std::set<CouplingId> changed;
    while (so_far.count() < size_ && take_step(so_far, changed, one)) {
    }
    if (so_far.count() < size_) {
      const std::size_t first = candidates_.size();
      add_single_freedoms(changed);
      for (std::size_t c = first; c < candidates_.size() && so_far.count() < size_; ++c) {
        if (so_far.add(candidates_[c].powers)) {
          one.cost += candidates_[c].cost;
          one.chosen.push_back(c);
        }
      }
    }
    if (so_far.count() == size_) {
      found.push_back(std::move(one));
    }
  }

  bool take_step(Independence& so_far, std::set<CouplingId>& changed, Found& one) const {
    const Candidate* best = nullptr;
    std::size_t best_index = 0;
    for (std::size_t c = 0; c < candidates_.size(); ++c) {
      const Candidate& candidate = candidates_[c];
      const auto freed = static_cast<int>(candidate.powers.cols());
      const bool is_better =
          best == nullptr ||
          candidate.cost * static_cast<int>(best->powers.cols()) < best->cost * freed;
      Independence next = so_far;
      if (is_better && !changed.contains(candidate.change.coupling) && next.add(candidate.powers)) {
        best = &candidate;
        best_index = c;
      }
    }
    if (best == nullptr) {
      return false;
    }
    so_far.add(best->powers);
    changed.insert(best->change.coupling);
    one.cost += best->cost;
    one.chosen.push_back(best_index);
    return true;
  }

  // Turns and shifts along the world axes; one that would leave a coupling nothing to bear is among
  // the candidates already.
  void add_single_freedoms(const std::set<CouplingId>& changed) {
    for (int e = 0; e < mechanism_.topology.coupling_count(); ++e) {
      const int least = actuated_.contains({e}) ? 1 : 2;
      if (changed.contains({e}) || passive_actions_of({e}) < least) {
        continue;
      }
      for (int i = 0; i < 3; ++i) {
        for (const Twist& twist :
             {unit_rotation(Vec3::Unit(i), at(e)), unit_translation(Vec3(Vec3::Unit(i)))}) {
          add({.coupling = {e}, .to = std::nullopt, .is_left_out = false, .added = {twist}},
              kCostOfOwnType);
        }
      }
    }
  }

  int passive_actions_of(CouplingId id) const {
    const CouplingTopology& coupling = mechanism_.topology.coupling(id);
    int count = 0;
    for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
      count += mechanism_.topology.actions[static_cast<std::size_t>(a)].actuator < 0 ? 1 : 0;
    }
    return count;
  }

  // Single freedoms of one coupling become one change.
  std::vector<CouplingChange> changes_of(const Found& found) const {
    std::vector<CouplingChange> changes;
    for (const std::size_t c : found.chosen) {
      const CouplingChange& change = candidates_[c].change;
      const auto same = std::ranges::find(changes, change.coupling, &CouplingChange::coupling);
      if (same != changes.end()) {
        same->added.insert(same->added.end(), change.added.begin(), change.added.end());
      } else {
        changes.push_back(change);
      }
    }
    std::ranges::stable_sort(changes, {}, &CouplingChange::coupling);
    return changes;
  }

  const Mechanism& mechanism_;
  const std::vector<RedundantConstraint>& constraints_;
  Eigen::Index size_ = 0;          ///< how many there are
  std::set<CouplingId> actuated_;  ///< with a freedom that an actuator drives
  std::vector<Candidate> candidates_;
};

// Up to `most` sets that remove all the constraints, the cheapest first.
std::vector<std::vector<CouplingChange>> search_changes(
    const Mechanism& mechanism, const std::vector<RedundantConstraint>& constraints, int most) {
  return ChangeSearch(mechanism, constraints).run(most);
}

}  // namespace

Mechanism released(const Mechanism& mechanism, const std::vector<CouplingChange>& changes) {
  Mechanism result = mechanism;
  Topology& topology = result.topology;
  topology.freedoms.clear();
  result.geometry.motions.clear();
  for (int e = 0; e < topology.coupling_count(); ++e) {
    CouplingTopology& coupling = topology.couplings[static_cast<std::size_t>(e)];
    const auto first = static_cast<std::ptrdiff_t>(coupling.first_freedom);
    coupling.first_freedom = topology.freedom_count();
    for (std::ptrdiff_t f = first; f < first + coupling.freedom_count; ++f) {
      topology.freedoms.push_back(mechanism.topology.freedoms[static_cast<std::size_t>(f)]);
      result.geometry.motions.push_back(mechanism.geometry.motions[static_cast<std::size_t>(f)]);
    }
    for (const CouplingChange& change : changes) {
      for (std::size_t i = 0; change.coupling.value == e && i < change.added.size(); ++i) {
        const bool turns = !change.added[i].angular.isZero(0.0);
        topology.freedoms.push_back({.coupling = {e}, .name = "added", .is_rotation = turns});
        result.geometry.motions.push_back(change.added[i]);
        ++coupling.freedom_count;
      }
    }
  }
  return result;
}

Repair verify_repair(const Mechanism& mechanism,
                     const MotionCounts& before,
                     std::vector<CouplingChange> changes) {
  const Mechanism better = released(mechanism, changes);
  const CoordinateBasis basis = motion_basis(better.geometry, OrderChoice::spatial);
  const Elimination elimination(velocity_system(better.topology, better.geometry, basis), {});
  Repair repair;
  for (const CouplingChange& change : changes) {
    repair.freed += static_cast<int>(change.added.size());
  }
  repair.changes = std::move(changes);
  repair.after = motion_counts(better, basis.order(), elimination.rank());
  repair.is_verified = repair.after.net_freedom == before.net_freedom &&
                       repair.after.net_constraint == before.net_constraint - repair.freed;
  return repair;
}

std::vector<Repair> find_repairs(const Mechanism& mechanism,
                                 const MotionCounts& before,
                                 const Redundancies& redundancies,
                                 int most) {
  std::vector<Repair> repairs;
  if (redundancies.constraints.empty()) {
    return repairs;
  }
  for (std::vector<CouplingChange>& changes :
       search_changes(mechanism, redundancies.constraints, most)) {
    repairs.push_back(verify_repair(mechanism, before, std::move(changes)));
  }
  std::erase_if(repairs, [](const Repair& repair) { return !repair.is_verified; });
  return repairs;
}

}  // namespace kinestat
