#include "mechanism/gears/planet_fit.hpp"

#include <algorithm>

#include "description/gear_expansion.hpp"
#include "mechanism/gears/internal/gear_binder.hpp"
#include "mechanism/gears/internal/planet_spacing.hpp"

namespace kinestat {

std::vector<PlanetFit> find_planet_fits(const MechanismDescription& description) {
  std::vector<PlanetFit> fits;
  if (!description.gears || !has_all_meshes(description)) {
    return fits;
  }
  Diagnostics ignored;
  Evaluator evaluator = make_evaluator(description, ignored);
  const GearsDescription& gears = *description.gears;
  const GearTrain train = find_gear_train(description);
  const auto numbers = bind_gear_numbers<double>(gears, train, evaluator);
  const auto layout = numbers ? find_layout<double>(train, *numbers) : std::nullopt;
  if (!layout) {
    return fits;
  }
  for (const PlanetSet& set : bind_planet_sets(gears, layout->train, evaluator)) {
    const std::vector<NeighbourPlanets> neighbours = find_neighbours(set, *layout, *numbers);
    if (set.count > 1 && !neighbours.empty()) {
      const auto nearest = std::ranges::min_element(neighbours, {}, &NeighbourPlanets::clearance);
      fits.push_back(
          {.planet = set.counted->name.text,
           .count = set.count,
           .assembles = blocking_sum(set, assembly_sums(set, layout->train, *numbers)) == 0,
           .clearance = nearest->clearance()});
    }
  }
  return fits;
}

}  // namespace kinestat
