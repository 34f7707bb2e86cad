#include "studies/mobility/grubler.hpp"

#include <algorithm>

namespace kinestat {

std::string name_of_class(std::size_t prevented) {
  constexpr std::array<const char*, 7> kNumerals = {"0", "I", "II", "III", "IV", "V", "VI"};
  return std::string("P_") + kNumerals.at(prevented);
}

GrublerCount count_by_grubler(const Topology& topology, const Topology& in_space, int order) {
  GrublerCount count{.order = order,
                     .bodies = topology.body_count(),
                     .couplings = topology.coupling_count(),
                     .freedoms = topology.freedom_count(),
                     .mobility = 0,
                     .classes = {}};
  for (std::size_t e = 0; e < topology.couplings.size(); ++e) {
    const int prevented = std::max(0, 6 - in_space.couplings[e].freedom_count);
    PairClass& one = count.classes[static_cast<std::size_t>(prevented)];
    one.couplings.push_back({static_cast<int>(e)});
    one.freedoms += topology.couplings[e].freedom_count;
  }
  count.mobility = order * (count.bodies - 1 - count.couplings) + count.freedoms;
  return count;
}

}  // namespace kinestat
