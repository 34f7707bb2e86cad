#include "mechanism/gears/internal/planet_spacing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace kinestat {

namespace {

long long tooth_count(int member, const GearNumbers& numbers) {
  return std::llround(numbers.teeth[static_cast<std::size_t>(member)]);
}

class NeighbourSearch {
 public:
  NeighbourSearch(const PlanetSet& set, const GearLayout& layout, const GearNumbers& numbers)
      : set_(set), layout_(layout), train_(layout.train), numbers_(numbers) {}

  std::vector<NeighbourPlanets> run() {
    for (const int p : set_.planets) {
      for (const int m : train_.axes[static_cast<std::size_t>(p)].members) {
        try_pair(m, m);
      }
    }
    for (std::size_t m = 0; m < train_.first.size(); ++m) {
      const int a = train_.first[m];
      const int b = train_.second[m];
      const bool is_in_set = std::ranges::find(set_.planets, axis_of(a)) != set_.planets.end();
      if (is_in_set && axis_of(b) >= 0) {
        try_pair(a, b);
      }
    }
    return std::move(found_);
  }

 private:
  int axis_of(int member) const { return train_.axis_of[static_cast<std::size_t>(member)]; }

  const Vec3& centre_of(int member) const {
    return layout_.centres[static_cast<std::size_t>(axis_of(member))];
  }

  // Of the tip circle, with the module of one of its meshes.
  double tip_radius(int member) const {
    for (std::size_t m = 0; m < train_.first.size(); ++m) {
      if (train_.first[m] == member || train_.second[m] == member) {
        const auto sum = static_cast<double>(tooth_count(train_.first[m], numbers_) +
                                             tooth_count(train_.second[m], numbers_));
        const double module =
            numbers_.module[m].value_or(2.0 * layout_.meshes[m].distance / std::abs(sum));
        return 0.5 * module * (static_cast<double>(tooth_count(member, numbers_)) + 2.0);
      }
    }
    return 0.0;
  }

  void try_pair(int a, int b) {
    const double angle = 2.0 * std::numbers::pi / set_.count;
    double distance = std::numeric_limits<double>::infinity();
    for (const double turn : {angle, -angle}) {
      const Vec3 next = Eigen::AngleAxisd(turn, Vec3::UnitZ()) * centre_of(b);
      distance = std::min(distance, (next - centre_of(a)).norm());
    }
    found_.push_back(
        {.first = a, .second = b, .distance = distance, .needed = tip_radius(a) + tip_radius(b)});
  }

  const PlanetSet& set_;
  const GearLayout& layout_;
  const GearTrain& train_;
  const GearNumbers& numbers_;
  std::vector<NeighbourPlanets> found_;
};

}  // namespace

std::vector<AssemblyMesh> assembly_meshes(const PlanetSet& set,
                                          const GearTrain& train,
                                          const GearNumbers& numbers) {
  std::vector<AssemblyMesh> result;
  const auto place = [&](int member) {
    const int axis = train.axis_of[static_cast<std::size_t>(member)];
    const auto at = std::ranges::find(set.planets, axis);
    return at == set.planets.end() ? -1 : static_cast<int>(at - set.planets.begin());
  };
  for (std::size_t m = 0; m < train.first.size(); ++m) {
    int planet = train.first[m];
    int mate = train.second[m];
    if (place(planet) < 0) {
      std::swap(planet, mate);
    }
    if (place(planet) >= 0) {
      result.push_back({.planet = place(planet),
                        .teeth = tooth_count(planet, numbers),
                        .mate = place(mate),
                        .mate_teeth = tooth_count(mate, numbers)});
    }
  }
  return result;
}

std::vector<long long> assembly_sums(const PlanetSet& set,
                                     const GearTrain& train,
                                     const GearNumbers& numbers) {
  constexpr std::size_t kMostPlanets = 3;
  return set.planets.size() > kMostPlanets ? std::vector<long long>()
                                           : assembly_teeth(assembly_meshes(set, train, numbers),
                                                            static_cast<int>(set.planets.size()));
}

long long blocking_sum(const PlanetSet& set, const std::vector<long long>& sums) {
  const auto blocking =
      std::ranges::find_if(sums, [&](long long sum) { return sum % set.count != 0; });
  return blocking == sums.end() ? 0 : *blocking;
}

std::vector<NeighbourPlanets> find_neighbours(const PlanetSet& set,
                                              const GearLayout& layout,
                                              const GearNumbers& numbers) {
  return NeighbourSearch(set, layout, numbers).run();
}

std::vector<NeighbourPlanets> find_touching(const PlanetSet& set,
                                            const GearLayout& layout,
                                            const GearNumbers& numbers) {
  std::vector<NeighbourPlanets> pairs = find_neighbours(set, layout, numbers);
  std::erase_if(pairs, [](const NeighbourPlanets& pair) { return pair.distance > pair.needed; });
  return pairs;
}

}  // namespace kinestat
