#include "mechanism/gears/gear_train.hpp"

#include <algorithm>
#include <utility>

#include "core/index.hpp"
#include "mechanism/gears/internal/shaft_groups.hpp"

namespace kinestat {

namespace {

enum class Place { unknown, main_axis, beside };

// What turns about one axis.
struct AxisGroup {
  std::vector<int> shafts;
  std::vector<int> members;
  std::vector<int> meshes;
  int carrier = -1;  ///< the group that bears it, if it is a planet
  Place place = Place::unknown;
  const GearAxisDescription* declared = nullptr;
  int axis = -1;  ///< of the train
};

class TrainFinder {
 public:
  explicit TrainFinder(const MechanismDescription& description)
      : description_(description),
        gears_(*description.gears),
        found_(find_shaft_groups(description)) {}

  GearTrain find() {
    train_.first = found_.first;
    train_.second = found_.second;
    collect();
    place_by_words();
    place_carriers();
    place_the_rest();
    add_axes();
    for (std::size_t i = 0; i < gears_.members.size(); ++i) {
      train_.axis_of.push_back(groups_[at(group_of(static_cast<int>(i)))].axis);
    }
    find_hands();
    return std::move(train_);
  }

 private:
  const Shaft& shaft(int s) const { return found_.shafts[at(s)]; }

  const GearMember& member(int i) const { return gears_.members[at(i)]; }

  int group_of(int member) const { return shaft(found_.shaft_of[at(member)]).group; }

  // The group with which one meshes there.
  int mate(int mesh, int group) const {
    const int first = group_of(train_.first[at(mesh)]);
    return first == group ? group_of(train_.second[at(mesh)]) : first;
  }

  int count() const { return static_cast<int>(groups_.size()); }

  void collect() {
    groups_.resize(at(found_.count));
    for (int s = 0; s < static_cast<int>(found_.shafts.size()); ++s) {
      AxisGroup& group = groups_[at(shaft(s).group)];
      group.shafts.push_back(s);
      group.members.insert(group.members.end(), shaft(s).members.begin(), shaft(s).members.end());
      group.meshes.insert(group.meshes.end(), shaft(s).meshes.begin(), shaft(s).meshes.end());
      if (shaft(s).carrier >= 0) {
        group.carrier = shaft(shaft(s).carrier).group;
        group.place = Place::beside;
      }
    }
    for (int g = 0; g < count(); ++g) {
      AxisGroup& group = groups_[at(g)];
      std::ranges::sort(group.members);
      if (group.members.empty() && !is_carrier(g)) {
        group.place = Place::main_axis;  // what else the mechanism has
      }
    }
    for (const GearAxisDescription& axis : gears_.axes) {
      for (const Name& body : axis.bodies) {
        if (const int s = found_.shaft_named(body.text); s >= 0) {
          AxisGroup& group = groups_[at(shaft(s).group)];
          group.declared = group.declared == nullptr ? &axis : group.declared;
        }
      }
    }
  }

  void place_by_words() {
    for (AxisGroup& group : groups_) {
      if (group.place != Place::unknown) {
        continue;
      }
      const bool is_beside = std::ranges::any_of(group.members, [&](int i) {
        return member(i).count || member(i).centre_distance || member(i).side == PlanetSide::right;
      });
      if (group.declared != nullptr) {
        group.place = group.declared == &gears_.axes.front() ? Place::main_axis : Place::beside;
      } else if (is_beside) {
        group.place = Place::beside;
      }
    }
  }

  bool is_carrier(int g) const {
    return std::ranges::any_of(groups_, [&](const AxisGroup& one) { return one.carrier == g; });
  }

  bool meshes_with(int g, Place place) const {
    return std::ranges::any_of(groups_[at(g)].meshes, [&](int mesh) {
      const AxisGroup& other = groups_[at(mate(mesh, g))];
      return other.carrier < 0 && other.place == place;
    });
  }

  bool has_ring(const AxisGroup& group) const {
    return std::ranges::any_of(group.members, [&](int i) { return member(i).internal; });
  }

  void place_carriers() {
    for (int g = 0; g < count(); ++g) {
      AxisGroup& group = groups_[at(g)];
      if (group.place == Place::unknown && (is_carrier(g) || has_ring(group)) &&
          !meshes_with(g, Place::main_axis)) {
        group.place = Place::main_axis;
      }
    }
  }

  // The first group without a place that meshes with one of that place gets the other.
  bool place_one(Place beside, Place place) {
    for (int g = 0; g < count(); ++g) {
      if (groups_[at(g)].place == Place::unknown && meshes_with(g, beside)) {
        groups_[at(g)].place = place;
        return true;
      }
    }
    return false;
  }

  // Whether groups that mesh with each other, from this one on, have one on the main axis.
  bool reaches_main_axis(int begin) const {
    std::vector<int> reached = {begin};
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const AxisGroup& group = groups_[at(reached[i])];
      if (group.place == Place::main_axis) {
        return true;
      }
      for (const int mesh : group.meshes) {
        const int other = mate(mesh, reached[i]);
        if (groups_[at(other)].carrier < 0 && std::ranges::find(reached, other) == reached.end()) {
          reached.push_back(other);
        }
      }
    }
    return false;
  }

  // The first group without a place that meshes its way to none on the main axis begins there.
  bool place_first() {
    for (int g = 0; g < count(); ++g) {
      if (groups_[at(g)].place == Place::unknown && !reaches_main_axis(g)) {
        groups_[at(g)].place = Place::main_axis;
        return true;
      }
    }
    return false;
  }

  void place_the_rest() {
    while (place_one(Place::main_axis, Place::beside) || place_first() ||
           place_one(Place::beside, Place::main_axis)) {
    }
  }

  // The axis from which a group beside it stands off: that of its carrier, or the main axis.
  int centre_of(const AxisGroup& group) const {
    return group.carrier < 0 ? -1 : groups_[at(group.carrier)].axis;
  }

  bool stands_on(int g, const AxisGroup& beside) const {
    const AxisGroup& group = groups_[at(g)];
    return group.place == Place::main_axis ? centre_of(beside) < 0
                                           : group.axis >= 0 && group.axis == centre_of(beside);
  }

  bool has_distance(int g) const {
    const AxisGroup& group = groups_[at(g)];
    const bool is_declared = group.declared != nullptr && group.declared->centre_distance;
    return is_declared ||
           std::ranges::any_of(group.members,
                               [&](int i) { return member(i).centre_distance.has_value(); }) ||
           std::ranges::any_of(group.meshes,
                               [&](int mesh) { return stands_on(mate(mesh, g), group); });
  }

  // Those that stand off from the main axis first. Chains begin where something tells the distance.
  void add_axes() {
    for (const bool are_of_main : {true, false}) {
      for (const bool need_distance : {true, false}) {
        for (int g = 0; g < count(); ++g) {
          const AxisGroup& group = groups_[at(g)];
          const bool is_of_main =
              group.carrier < 0 || groups_[at(group.carrier)].place == Place::main_axis;
          if (group.place == Place::beside && group.axis < 0 && !group.members.empty() &&
              is_of_main == are_of_main && (has_distance(g) || !need_distance)) {
            add_chain(g);
          }
        }
      }
    }
  }

  void add_chain(int root) {
    std::vector<int> waiting = {root};
    add_axis(root, -1, -1);
    for (std::size_t next = 0; next < waiting.size(); ++next) {
      const int g = waiting[next];
      for (const int mesh : groups_[at(g)].meshes) {
        const int other = mate(mesh, g);
        const AxisGroup& group = groups_[at(other)];
        if (group.place == Place::beside && group.axis < 0 &&
            group.carrier == groups_[at(g)].carrier) {
          add_axis(other, groups_[at(g)].axis, mesh);
          waiting.push_back(other);
        }
      }
    }
  }

  void add_axis(int g, int neighbour, int mesh) {
    AxisGroup& group = groups_[at(g)];
    GearAxis axis{.bodies = bodies_of(group),
                  .members = group.members,
                  .carrier = group.carrier < 0 ? description_.ground.text : carrier_of(group),
                  .about = centre_of(group),
                  .on_centre = {},
                  .neighbour = neighbour,
                  .neighbour_mesh = mesh};
    for (const int one : group.meshes) {
      if (stands_on(mate(one, g), group)) {
        axis.on_centre.push_back(one);
      }
    }
    if (group.declared != nullptr) {
      axis.side = group.declared->side;
      axis.distance = group.declared->centre_distance ? &*group.declared->centre_distance : nullptr;
    }
    for (const int i : group.members) {
      axis.side = member(i).side == PlanetSide::right ? PlanetSide::right : axis.side;
      if (member(i).centre_distance && axis.distance == nullptr) {
        axis.distance = &*member(i).centre_distance;
        axis.distance_giver = member(i).body.text;
      }
    }
    axis.is_in_line = group.declared != nullptr && neighbour >= 0 && !has_distance(g);
    group.axis = static_cast<int>(train_.axes.size());
    train_.axes.push_back(std::move(axis));
  }

  const std::string& carrier_of(const AxisGroup& group) const {
    return shaft(shaft(group.shafts.front()).carrier).body;
  }

  std::vector<std::string> bodies_of(const AxisGroup& group) const {
    std::vector<std::string> bodies;
    for (const int s : group.shafts) {
      if (!shaft(s).is_on_ground) {
        bodies.push_back(shaft(s).body);
      }
    }
    return bodies;
  }

  void find_hands() {
    train_.hand.assign(gears_.meshes.size(), 1);
    std::vector<int> hand(gears_.members.size(), 0);
    for (std::size_t begin = 0; begin < gears_.meshes.size(); ++begin) {
      int& root = hand[at(train_.first[begin])];
      root = root == 0 && hand[at(train_.second[begin])] == 0 ? 1 : root;
      for (bool goes_on = true; goes_on;) {
        goes_on = false;
        for (std::size_t m = 0; m < gears_.meshes.size(); ++m) {
          goes_on = hand_over(m, hand) || goes_on;
        }
      }
    }
    for (std::size_t m = 0; m < gears_.meshes.size(); ++m) {
      train_.hand[m] = hand[at(train_.first[m])];
    }
  }

  // Gears that mesh outside each other have opposite hands, a ring that of its gear.
  bool hand_over(std::size_t mesh, std::vector<int>& hand) const {
    int& a = hand[at(train_.first[mesh])];
    int& b = hand[at(train_.second[mesh])];
    const bool is_internal =
        member(train_.first[mesh]).internal || member(train_.second[mesh]).internal;
    if ((a == 0) == (b == 0)) {
      return false;
    }
    (a == 0 ? a : b) = (a == 0 ? b : a) * (is_internal ? 1 : -1);
    return true;
  }

  const MechanismDescription& description_;
  const GearsDescription& gears_;
  const ShaftGroups found_;
  std::vector<AxisGroup> groups_;
  GearTrain train_;
};

}  // namespace

int GearTrain::axis_on(std::string_view body) const {
  const auto place = std::ranges::find_if(axes, [&](const GearAxis& axis) {
    return std::ranges::find(axis.bodies, body) != axis.bodies.end();
  });
  return place == axes.end() ? -1 : static_cast<int>(place - axes.begin());
}

int GearTrain::axis_between(std::string_view tail, std::string_view head) const {
  const int of_tail = axis_on(tail);
  const int of_head = axis_on(head);
  const bool is_head = of_head >= 0 && (of_tail < 0 || axes[at(of_head)].about == of_tail);
  return is_head ? of_head : of_tail;
}

GearTrain find_gear_train(const MechanismDescription& description) {
  return TrainFinder(description).find();
}

}  // namespace kinestat
