#include "mechanism/gears/internal/shaft_groups.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "core/index.hpp"
#include "description/gear_expansion.hpp"

namespace kinestat {

namespace {

enum class Role { unknown, central, planet };

class ShaftGrouper {
 public:
  explicit ShaftGrouper(const MechanismDescription& description)
      : description_(description), gears_(*description.gears) {}

  ShaftGroups find() {
    collect();
    role_.assign(shafts().size(), Role::unknown);
    find_holders();
    for (int s = 0; s < count(); ++s) {
      find_role(s);
    }
    while (tell_mates(Role::central, Role::planet) || begin_one() ||
           tell_mates(Role::planet, Role::central)) {
    }
    join_groups();
    return std::move(result_);
  }

 private:
  std::vector<Shaft>& shafts() { return result_.shafts; }

  int count() const { return static_cast<int>(result_.shafts.size()); }

  const Shaft& shaft(int s) const { return result_.shafts[at(s)]; }

  const MeshDescription& mesh(int m) const { return gears_.meshes[at(m)]; }

  const GearMember& member(int i) const { return gears_.members[at(i)]; }

  bool is_ground(const std::string& body) const { return body == description_.ground.text; }

  void collect() {
    std::map<std::string, int> members;
    const auto add = [&](const std::string& body) {
      const bool is_fixed = is_ground(body);
      const auto known = result_.of_body.find(body);
      if (!is_fixed && known != result_.of_body.end()) {
        return known->second;
      }
      shafts().push_back({.body = body, .is_on_ground = is_fixed});
      if (!is_fixed) {
        result_.of_body.emplace(body, count() - 1);
      }
      return count() - 1;
    };
    for (int i = 0; i < static_cast<int>(gears_.members.size()); ++i) {
      members.emplace(member(i).name.text, i);
      const int s = add(member(i).body.text);
      shafts()[at(s)].members.push_back(i);
      result_.shaft_of.push_back(s);
    }
    for (const BodyDescription& body : description_.bodies) {
      add(body.name.text);
    }
    for (int m = 0; m < static_cast<int>(gears_.meshes.size()); ++m) {
      result_.first.push_back(members.at(mesh(m).first.text));
      result_.second.push_back(members.at(mesh(m).second.text));
      for (const int i : {result_.first.back(), result_.second.back()}) {
        shafts()[at(result_.shaft_of[at(i)])].meshes.push_back(m);
      }
      carriers_.push_back(mesh(m).carrier && !is_ground(mesh(m).carrier->text)
                              ? result_.shaft_named(mesh(m).carrier->text)
                              : -1);
    }
  }

  // What bears each shaft, meshes apart. A gear on the ground needs no bearing.
  void find_holders() {
    holders_.resize(shafts().size());
    for (const CouplingDescription& coupling : description_.couplings) {
      if (coupling.is_mesh()) {
        continue;
      }
      for (const auto& [one, other] :
           {std::pair(&coupling.tail, &coupling.head), std::pair(&coupling.head, &coupling.tail)}) {
        if (const int s = result_.shaft_named(one->text); s >= 0) {
          holders_[at(s)].push_back(other->text);
        }
      }
    }
  }

  bool is_carrier(int s) const { return std::ranges::find(carriers_, s) != carriers_.end(); }

  bool has_ring(int s) const {
    return std::ranges::any_of(shaft(s).members, [&](int i) { return member(i).internal; });
  }

  bool has_words_of_planets(int s) const {
    return std::ranges::any_of(shaft(s).members, [&](int i) {
      return member(i).count || member(i).centre_distance || member(i).side == PlanetSide::right;
    });
  }

  // The member of a mesh that is not of the shaft.
  int mate_member(int m, int s) const {
    const int first = result_.first[at(m)];
    return result_.shaft_of[at(first)] == s ? result_.second[at(m)] : first;
  }

  void set(int s, Role role, int carrier) {
    role_[at(s)] = role;
    shafts()[at(s)].carrier = role == Role::planet ? carrier : -1;
  }

  void find_role(int s) {
    std::vector<int> carriers;
    bool meshes_on_ground = false;
    std::optional<int> of_ring;
    for (const int m : shaft(s).meshes) {
      const int carrier = carriers_[at(m)];
      if (carrier < 0) {
        meshes_on_ground = true;
        continue;
      }
      if (std::ranges::find(carriers, carrier) == carriers.end()) {
        carriers.push_back(carrier);
      }
      if (member(mate_member(m, s)).internal && !of_ring) {
        of_ring = carrier;
      }
    }
    if (carriers.empty()) {
      return;
    }
    const std::vector<std::string>& holders = holders_[at(s)];
    const std::string& carrier = shaft(carriers.front()).body;
    const auto is_it = [&](const std::string& holder) { return holder == carrier; };
    const bool is_borne_elsewhere = !holders.empty() && std::ranges::none_of(holders, is_it);
    if (has_ring(s) || is_carrier(s) || shaft(s).is_on_ground) {
      set(s, Role::central, -1);
    } else if (of_ring) {
      set(s, Role::planet, *of_ring);
    } else if (has_words_of_planets(s) && !(is_borne_elsewhere && meshes_on_ground)) {
      set(s, Role::planet, carriers.front());
    } else if (carriers.size() == 1 && !holders.empty()) {
      const bool is_borne_by_it = std::ranges::all_of(holders, is_it);
      set(s, is_borne_by_it ? Role::planet : Role::central, carriers.front());
    }
  }

  bool has_role_to_find(int s) const {
    return role_[at(s)] == Role::unknown &&
           std::ranges::any_of(shaft(s).meshes, [&](int m) { return carriers_[at(m)] >= 0; });
  }

  // The first shaft without a role that meshes in a carrier with one of that role gets the other.
  bool tell_mates(Role known, Role other) {
    for (int s = 0; s < count(); ++s) {
      for (const int m : shaft(s).meshes) {
        if (has_role_to_find(s) && carriers_[at(m)] >= 0 &&
            role_[at(result_.mate(m, s))] == known) {
          set(s, other, carriers_[at(m)]);
          return true;
        }
      }
    }
    return false;
  }

  // Whether shafts that mesh with each other in carriers, from this one on, have one that is
  // central.
  bool reaches_centre(int begin) const {
    std::vector<int> reached = {begin};
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const int s = reached[i];
      if (role_[at(s)] == Role::central) {
        return true;
      }
      for (const int m : shaft(s).meshes) {
        const int other = result_.mate(m, s);
        if (carriers_[at(m)] >= 0 && std::ranges::find(reached, other) == reached.end()) {
          reached.push_back(other);
        }
      }
    }
    return false;
  }

  // The first shaft that meshes its way to no central one is one.
  bool begin_one() {
    for (int s = 0; s < count(); ++s) {
      if (has_role_to_find(s) && !reaches_centre(s)) {
        set(s, Role::central, -1);
        return true;
      }
    }
    return false;
  }

  int root(int s) const {
    while (parent_[at(s)] != s) {
      s = parent_[at(s)];
    }
    return s;
  }

  void join_groups() {
    parent_.resize(shafts().size());
    std::iota(parent_.begin(), parent_.end(), 0);
    for (int s = 0; s < count(); ++s) {
      is_plain_.push_back(shaft(s).members.empty() && !is_carrier(s));
    }
    for (int m = 0; m < static_cast<int>(gears_.meshes.size()); ++m) {
      for (const int i : {result_.first[at(m)], result_.second[at(m)]}) {
        const int s = result_.shaft_of[at(i)];
        if (carriers_[at(m)] >= 0 && shaft(s).carrier < 0) {
          join(s, carriers_[at(m)]);
        }
      }
    }
    for (const GearAxisDescription& axis : gears_.axes) {
      for (const Name& body : axis.bodies) {
        join(result_.shaft_named(axis.bodies.front().text), result_.shaft_named(body.text));
      }
    }
    join_clutched();
    number_groups();
  }

  // Along a row of clutches, from shafts with gears or planets on; at last plain ones by
  // themselves.
  void join_clutched() {
    for (const bool joins_plain : {false, true}) {
      for (bool goes_on = true; goes_on;) {
        goes_on = false;
        for (const CouplingDescription& coupling : description_.couplings) {
          const int a = result_.shaft_named(coupling.tail.text);
          const int b = result_.shaft_named(coupling.head.text);
          const bool counts = joins_one_axis(coupling.type) && a >= 0 && b >= 0 &&
                              (joins_plain || !is_plain_[at(root(a))] || !is_plain_[at(root(b))]);
          goes_on = (counts && join(a, b)) || goes_on;
        }
      }
    }
  }

  // Joins the groups of two shafts, which must be planets of one carrier or no planets; plain
  // shafts become what they join. Whether that was news.
  bool join(int a, int b) {
    if (a < 0 || b < 0) {
      return false;
    }
    const auto [low, high] = std::minmax({root(a), root(b)});
    const bool are_alike =
        is_plain_[at(low)] || is_plain_[at(high)] || shaft(low).carrier == shaft(high).carrier;
    if (low == high || !are_alike) {
      return false;
    }
    if (is_plain_[at(low)]) {
      shafts()[at(low)].carrier = shaft(high).carrier;
    }
    is_plain_[at(low)] = is_plain_[at(low)] && is_plain_[at(high)];
    parent_[at(high)] = low;
    return true;
  }

  void number_groups() {
    std::map<int, int> numbers;
    for (int s = 0; s < count(); ++s) {
      const auto [place, is_new] = numbers.emplace(root(s), result_.count);
      result_.count += is_new ? 1 : 0;
      shafts()[at(s)].group = place->second;
      shafts()[at(s)].carrier = shaft(root(s)).carrier;
    }
  }

  const MechanismDescription& description_;
  const GearsDescription& gears_;
  std::vector<int> carriers_;                      ///< of each mesh: shaft that moves, or -1
  std::vector<std::vector<std::string>> holders_;  ///< of each shaft
  std::vector<Role> role_;                         ///< of each shaft in carriers that move
  std::vector<int> parent_;                        ///< of each shaft, as a forest of groups
  std::vector<bool>
      is_plain_;  ///< of each shaft: has no gears and carries none; of a root: its group
  ShaftGroups result_;
};

}  // namespace

int ShaftGroups::mate(int mesh, int shaft) const {
  const int one = shaft_of[at(first[at(mesh)])];
  return one == shaft ? shaft_of[at(second[at(mesh)])] : one;
}

int ShaftGroups::shaft_named(std::string_view body) const {
  const auto place = of_body.find(body);
  return place == of_body.end() ? -1 : place->second;
}

ShaftGroups find_shaft_groups(const MechanismDescription& description) {
  return ShaftGrouper(description).find();
}

}  // namespace kinestat
