#include "mechanism/gears/gear_train.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "description/gear_expansion.hpp"

namespace kinestat {

namespace {

enum class Place { unknown, main_axis, planet };

// A body that carries gears.
struct GearBody {
  std::string name;
  std::vector<int> members;
  std::vector<int> meshes;
  Place place = Place::unknown;
};

class TrainFinder {
 public:
  explicit TrainFinder(const MechanismDescription& description)
      : description_(description), gears_(*description.gears) {}

  GearTrain find() {
    collect();
    place_by_words();
    place_beside_rings();
    place_by_bearings();
    place_the_rest();
    add_planets();
    for (PlanetAxis& planet : train_.planets) {
      add_shafts(planet);
    }
    find_hands();
    return std::move(train_);
  }

 private:
  std::size_t body_of(int member) const { return body_of_[static_cast<std::size_t>(member)]; }

  const GearMember& member(int index) const {
    return gears_.members[static_cast<std::size_t>(index)];
  }

  void collect() {
    std::map<std::string, std::size_t> known;
    std::map<std::string, int> members;
    for (std::size_t i = 0; i < gears_.members.size(); ++i) {
      const GearMember& one = gears_.members[i];
      members.emplace(one.name.text, static_cast<int>(i));
      const auto [at, is_new] = known.emplace(one.body.text, bodies_.size());
      if (is_new) {
        bodies_.push_back({.name = one.body.text, .members = {}, .meshes = {}});
      }
      bodies_[at->second].members.push_back(static_cast<int>(i));
      body_of_.push_back(at->second);
    }
    for (std::size_t i = 0; i < gears_.meshes.size(); ++i) {
      const MeshDescription& mesh = gears_.meshes[i];
      train_.first.push_back(members.at(mesh.first.text));
      train_.second.push_back(members.at(mesh.second.text));
      bodies_[body_of(train_.first.back())].meshes.push_back(static_cast<int>(i));
      bodies_[body_of(train_.second.back())].meshes.push_back(static_cast<int>(i));
    }
  }

  // The member of a mesh that is not on the body.
  int mate(int mesh, std::size_t body) const {
    const auto m = static_cast<std::size_t>(mesh);
    return body_of(train_.first[m]) == body ? train_.second[m] : train_.first[m];
  }

  void place_by_words() {
    for (GearBody& body : bodies_) {
      const bool is_ring =
          std::ranges::any_of(body.members, [&](int i) { return member(i).internal; });
      const bool is_planet = std::ranges::any_of(body.members, [&](int i) {
        return member(i).count || member(i).centre_distance || member(i).side == PlanetSide::right;
      });
      const bool is_carrier = std::ranges::any_of(gears_.meshes, [&](const MeshDescription& mesh) {
        return carrier_of(mesh, description_) == body.name;
      });
      body.place = is_ring || is_carrier ? Place::main_axis
                   : is_planet           ? Place::planet
                                         : Place::unknown;
    }
  }

  void place_beside_rings() {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      const bool meets_ring = std::ranges::any_of(
          bodies_[b].meshes, [&](int mesh) { return member(mate(mesh, b)).internal; });
      if (bodies_[b].place == Place::unknown && meets_ring) {
        bodies_[b].place = Place::planet;
      }
    }
  }

  // The one carrier of all meshes of a body, unless that is the ground or there are several.
  std::optional<std::string> moving_carrier(const GearBody& body) const {
    std::optional<std::string> result;
    for (const int mesh : body.meshes) {
      const std::string& carrier =
          carrier_of(gears_.meshes[static_cast<std::size_t>(mesh)], description_);
      if (carrier == description_.ground.text || (result && *result != carrier)) {
        return std::nullopt;
      }
      result = carrier;
    }
    return result;
  }

  // Where a carrier turns, planets are held by it alone, while something else holds, drives or
  // brakes suns. What has meshes on several carriers is no planet.
  void place_by_bearings() {
    std::map<std::string, std::vector<std::string>> held_by;
    for (const CouplingDescription& coupling : description_.couplings) {
      if (!coupling.is_mesh()) {
        held_by[coupling.tail.text].push_back(coupling.head.text);
        held_by[coupling.head.text].push_back(coupling.tail.text);
      }
    }
    for (GearBody& body : bodies_) {
      const std::optional<std::string> carrier = moving_carrier(body);
      const std::vector<std::string>& holders = held_by[body.name];
      if (body.place != Place::unknown || !carrier || holders.empty()) {
        continue;
      }
      const bool is_held_by_it = std::ranges::all_of(
          holders, [&](const std::string& holder) { return holder == *carrier; });
      body.place = is_held_by_it ? Place::planet : Place::main_axis;
    }
  }

  bool meshes_with(std::size_t body, Place place) const {
    return std::ranges::any_of(bodies_[body].meshes, [&](int mesh) {
      return bodies_[body_of(mate(mesh, body))].place == place;
    });
  }

  // The first body without a place that meshes with one of that place gets the other.
  bool place_one(Place beside, Place place) {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (bodies_[b].place == Place::unknown && meshes_with(b, beside)) {
        bodies_[b].place = place;
        return true;
      }
    }
    return false;
  }

  // Whether bodies that mesh with each other, from this one on, have one on the main axis.
  bool reaches_main_axis(std::size_t begin) const {
    std::vector<std::size_t> reached = {begin};
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const std::size_t body = reached[i];
      if (bodies_[body].place == Place::main_axis) {
        return true;
      }
      for (const int mesh : bodies_[body].meshes) {
        const std::size_t other = body_of(mate(mesh, body));
        if (std::ranges::find(reached, other) == reached.end()) {
          reached.push_back(other);
        }
      }
    }
    return false;
  }

  // The first body without a place that meshes its way to none on the main axis begins there.
  bool place_first() {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (bodies_[b].place == Place::unknown && !reaches_main_axis(b)) {
        bodies_[b].place = Place::main_axis;
        return true;
      }
    }
    return false;
  }

  void place_the_rest() {
    while (place_one(Place::main_axis, Place::planet) || place_first() ||
           place_one(Place::planet, Place::main_axis)) {
    }
  }

  // Chains of planets from their first on, so that each stands after its neighbour.
  void add_planets() {
    train_.planet_of.assign(gears_.members.size(), -1);
    std::vector<int> planet_of_body(bodies_.size(), -1);
    const auto add = [&](std::size_t body, int neighbour, int mesh) {
      planet_of_body[body] = static_cast<int>(train_.planets.size());
      train_.planets.push_back(planet(body, neighbour, mesh));
      for (const int member : bodies_[body].members) {
        train_.planet_of[static_cast<std::size_t>(member)] = planet_of_body[body];
      }
      waiting_.push_back(body);
    };
    for (std::size_t root = 0; root < bodies_.size(); ++root) {
      if (bodies_[root].place != Place::planet || planet_of_body[root] >= 0) {
        continue;
      }
      add(root, -1, -1);
      for (std::size_t next = waiting_.size() - 1; next < waiting_.size(); ++next) {
        const std::size_t body = waiting_[next];
        for (const int mesh : bodies_[body].meshes) {
          const std::size_t other = body_of(mate(mesh, body));
          if (bodies_[other].place == Place::planet && planet_of_body[other] < 0) {
            add(other, planet_of_body[body], mesh);
          }
        }
      }
    }
  }

  PlanetAxis planet(std::size_t index, int neighbour, int mesh) const {
    const GearBody& body = bodies_[index];
    PlanetAxis result{.body = body.name,
                      .members = body.members,
                      .on_main = {},
                      .neighbour = neighbour,
                      .neighbour_mesh = mesh};
    for (const int one : body.meshes) {
      if (bodies_[body_of(mate(one, index))].place == Place::main_axis) {
        result.on_main.push_back(one);
      }
    }
    for (const int i : body.members) {
      if (member(i).side == PlanetSide::right) {
        result.side = PlanetSide::right;
      }
      if (member(i).centre_distance && result.distance == nullptr) {
        result.distance = &*member(i).centre_distance;
      }
    }
    return result;
  }

  // Whether a body has no gears and carries none, so that only its clutches say where it turns.
  bool is_plain_shaft(const std::string& body) const {
    return body != description_.ground.text &&
           std::ranges::find(bodies_, body, &GearBody::name) == bodies_.end() &&
           std::ranges::none_of(gears_.meshes, [&](const MeshDescription& mesh) {
             return carrier_of(mesh, description_) == body;
           });
  }

  void add_shafts(PlanetAxis& planet) const {
    std::vector<std::string> joined = {planet.body};
    for (std::size_t i = 0; i < joined.size(); ++i) {
      for (const CouplingDescription& coupling : description_.couplings) {
        const bool is_at = coupling.tail.text == joined[i] || coupling.head.text == joined[i];
        const std::string& other =
            coupling.tail.text == joined[i] ? coupling.head.text : coupling.tail.text;
        if (is_at && coupling.type == CouplingType::clutch && is_plain_shaft(other) &&
            std::ranges::find(joined, other) == joined.end()) {
          joined.push_back(other);
        }
      }
    }
    planet.shafts.assign(joined.begin() + 1, joined.end());
  }

  void find_hands() {
    train_.hand.assign(gears_.meshes.size(), 1);
    std::vector<int> hand(gears_.members.size(), 0);
    for (std::size_t begin = 0; begin < gears_.meshes.size(); ++begin) {
      int& root = hand[static_cast<std::size_t>(train_.first[begin])];
      root = root == 0 && hand[static_cast<std::size_t>(train_.second[begin])] == 0 ? 1 : root;
      for (bool goes_on = true; goes_on;) {
        goes_on = false;
        for (std::size_t m = 0; m < gears_.meshes.size(); ++m) {
          goes_on = hand_over(m, hand) || goes_on;
        }
      }
    }
    for (std::size_t m = 0; m < gears_.meshes.size(); ++m) {
      train_.hand[m] = hand[static_cast<std::size_t>(train_.first[m])];
    }
  }

  // Gears that mesh outside each other have opposite hands, a ring that of its gear.
  bool hand_over(std::size_t mesh, std::vector<int>& hand) const {
    int& a = hand[static_cast<std::size_t>(train_.first[mesh])];
    int& b = hand[static_cast<std::size_t>(train_.second[mesh])];
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
  std::vector<GearBody> bodies_;
  std::vector<std::size_t> body_of_;  ///< of each member
  std::vector<std::size_t> waiting_;  ///< bodies of planets, in the order of `planets`
  GearTrain train_;
};

}  // namespace

int GearTrain::planet_on(std::string_view body) const {
  const auto at = std::ranges::find_if(planets, [&](const PlanetAxis& planet) {
    return planet.body == body || std::ranges::find(planet.shafts, body) != planet.shafts.end();
  });
  return at == planets.end() ? -1 : static_cast<int>(at - planets.begin());
}

GearTrain find_gear_train(const MechanismDescription& description) {
  return TrainFinder(description).find();
}

}  // namespace kinestat
