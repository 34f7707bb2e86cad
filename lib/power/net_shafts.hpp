// Bodies that count as one shaft when power is followed from shaft to shaft.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mechanism/gears/mesh.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// The shafts of a mechanism. Planets that mesh with each other on one carrier are one shaft, which
/// the first of them represents; every other body is a shaft of its own. `meshes` are those of the
/// mechanism. The topology must outlive it.
class NetShafts {
 public:
  NetShafts(const Topology& topology, std::span<const Mesh> meshes);

  BodyId shaft_of(BodyId body) const { return shaft_of_[index(body)]; }

  /// The carrier of a planet, which is a gear that only its carrier and its meshes hold. Empty for
  /// other bodies.
  const std::optional<BodyId>& carrier_of(BodyId body) const { return carrier_of_[index(body)]; }

  /// Whether a coupling joins a planet and its carrier. The power that the carrier gives is then
  /// the power of the wrench on the motion of the carrier.
  bool bears_planet(CouplingId id) const { return planet_on(id).has_value(); }

  /// The planet of such a coupling, which is its head or its tail. Empty for other couplings.
  std::optional<BodyId> planet_on(CouplingId id) const;

  /// Whether the powers of a coupling and of others between the same two shafts are summed, with
  /// their signs, as for the strands of a belt and the bearings of planets.
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
