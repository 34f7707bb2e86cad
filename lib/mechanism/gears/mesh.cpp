#include "mechanism/gears/mesh.hpp"

#include <algorithm>
#include <vector>

#include "core/index.hpp"
#include "couplings/kinds.hpp"
#include "mechanism/gears/hinge_lines.hpp"

namespace kinestat {

namespace {

// A carrier turns about one line with the one gear and about another with the other.
class CarrierSearch {
 public:
  CarrierSearch(const Topology& topology, const Geometry& geometry)
      : length_(geometry.length),
        lines_(find_hinge_lines(topology, geometry)),
        lines_at_(topology.bodies.size()),
        reach_(topology.bodies.size(), 0) {
    for (int line = 0; line < static_cast<int>(lines_.size()); ++line) {
      for (const BodyId body : lines_[at(line)].bodies) {
        lines_at_[at(body.value)].push_back(line);
        reach_[at(body.value)] += lines_[at(line)].bodies.size();
      }
    }
  }

  std::optional<BodyId> carrier_of(BodyId first, BodyId second) const {
    const bool is_first_near = reach_[at(first.value)] <= reach_[at(second.value)];
    const BodyId near = is_first_near ? first : second;
    const BodyId far = is_first_near ? second : first;
    std::optional<BodyId> found;
    for (const int line : lines_at_[at(near.value)]) {
      for (const BodyId body : lines_[at(line)].bodies) {
        const bool is_known = body == near || body == far || found == body;
        if (is_known || !turns_about_another_line(body, far, line)) {
          continue;
        }
        if (found) {
          return std::nullopt;
        }
        found = body;
      }
    }
    return found;
  }

 private:
  // Whether both are on a line that is another one than `line`.
  bool turns_about_another_line(BodyId body, BodyId other, int line) const {
    const std::vector<int>& a = lines_at_[at(body.value)];
    const std::vector<int>& b = lines_at_[at(other.value)];
    const std::vector<int>& shorter = a.size() <= b.size() ? a : b;
    const std::vector<int>& longer = a.size() <= b.size() ? b : a;
    return std::ranges::any_of(shorter, [&](int shared) {
      return std::ranges::binary_search(longer, shared) &&
             !are_one_line(lines_[at(line)], lines_[at(shared)], length_);
    });
  }

  double length_;
  std::vector<HingeLine> lines_;
  std::vector<std::vector<int>> lines_at_;  // of each body, ascending
  std::vector<std::size_t> reach_;          // of each body: the bodies on its lines
};

}  // namespace

std::vector<Mesh> find_meshes(const Topology& topology, const Geometry& geometry) {
  std::vector<Mesh> meshes;
  if (std::ranges::none_of(topology.couplings, joins_wheels, &CouplingTopology::type)) {
    return meshes;
  }
  const CarrierSearch search(topology, geometry);
  for (int e = 0; e < topology.coupling_count(); ++e) {
    const CouplingTopology& coupling = topology.coupling(CouplingId{e});
    if (joins_wheels(coupling.type)) {
      meshes.push_back(
          {.coupling = CouplingId{e}, .carrier = search.carrier_of(coupling.tail, coupling.head)});
    }
  }
  return meshes;
}

}  // namespace kinestat
