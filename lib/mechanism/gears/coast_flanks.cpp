#include "mechanism/gears/coast_flanks.hpp"

#include <algorithm>
#include <iterator>

namespace kinestat {

std::vector<int> coast_flanks_under(const Geometry& geometry,
                                    const std::vector<int>& before,
                                    const ForceOf& force_of) {
  std::vector<int> coast;
  for (std::size_t i = 0; i < geometry.other_flanks.size(); ++i) {
    const auto flank = static_cast<int>(i);
    const double force = force_of(geometry.other_flanks[i].action);
    if (force == 0.0 ? std::ranges::find(before, flank) != before.end() : force < 0.0) {
      coast.push_back(flank);
    }
  }
  return coast;
}

std::vector<int> pulling_teeth(const Mechanism& mechanism,
                               const std::vector<int>& coast,
                               const ForceOf& force_of) {
  std::vector<int> pulling;
  std::ranges::copy_if(mechanism.one_flanked, std::back_inserter(pulling), [&](int action) {
    return force_of(action) < 0.0;
  });
  const std::vector<int> fitting = coast_flanks_under(mechanism.geometry, coast, force_of);
  std::vector<int> wrong;
  std::ranges::set_symmetric_difference(fitting, coast, std::back_inserter(wrong));
  for (const int flank : wrong) {
    pulling.push_back(mechanism.geometry.other_flanks[static_cast<std::size_t>(flank)].action);
  }
  return pulling;
}

}  // namespace kinestat
