// Which bodies count as one shaft when power is followed from shaft to shaft.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mechanism/gears/mesh.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// Planets that mesh with each other on one carrier are one shaft, for which the first of them
/// stands; every other body is one of its own. `meshes` are those of the mechanism; the topology
/// must outlive it.
class NetShafts {
 public:
  NetShafts(const Topology& topology, std::span<const Mesh> meshes);

  BodyId shaft_of(BodyId body) const { return shaft_of_[index(body)]; }

  /// On which a planet turns: a gear that nothing holds but its carrier and teeth. Empty of others.
  const std::optional<BodyId>& carrier_of(BodyId body) const { return carrier_of_[index(body)]; }

  /// Whether it joins a planet and its carrier. What the carrier gives is then its wrench on the
  /// motion of the carrier.
  bool bears_planet(CouplingId id) const { return planet_on(id).has_value(); }

  /// The planet of such a coupling, which is its head or its tail; empty of others.
  std::optional<BodyId> planet_on(CouplingId id) const;

  /// Whether a coupling counts together with others between the same two, as the strands of a belt
  /// and the bearings of planets do: what is summed is what one side gives more than the other.
  bool is_summed(CouplingId id) const;

 private:
  static std::size_t index(BodyId body) { return static_cast<std::size_t>(body.value); }

  bool turns_on(BodyId gear, BodyId carrier) const;
  void find_planets(const Mesh& mesh);
  void join_planets(const Mesh& mesh);

  const Topology& topology_;
  std::vector<BodyId> shaft_of_;
  std::vector<std::optional<BodyId>> carrier_of_;
};

}  // namespace kinestat
