// The hinges on the axis of planets, which several equal planets press from all sides.
#pragma once

#include <optional>
#include <vector>

#include "mechanism/couplings/coupling_friction.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// A hinge on the axis of carriers of several equal planets, or of suns and rings that mesh with
/// them. Equal planets at equal angles press it from all sides, so that their forces across the
/// axis and their moments across it cancel; but as drawn, it bears those of one planet in the place
/// of all. Axial forces and moments about the axis add up.
struct CentralHinge {
  enum class Across {
    nothing,  ///< only planets press the bodies that it carries
    rest,     ///< what it bears with the wrenches of `planets` added
    shared  ///< as drawn: other couplings on the axis share what it bears, or planets have inertia
  };

  Vec3 axis = Vec3::UnitZ();  ///< a unit vector, as drawn
  Across across = Across::nothing;
  std::vector<CountedCoupling> planets;  ///< the meshes by which planets press what it carries
};

/// Finds the central hinge of each coupling; empty for couplings that are none.
std::vector<std::optional<CentralHinge>> find_central_hinges(const Mechanism& mechanism);

/// What a coupling bears, a force or a moment about its point, of a central hinge without what
/// cancels: `own` along the axis, and across it `with_planets`, its own and those of `planets`.
Vec3 borne(const std::optional<CentralHinge>& hinge, const Vec3& own, const Vec3& with_planets);

/// The force that a coupling bears [N]; `force_of` gives those of all couplings as drawn, of tail
/// on head, or none where equilibrium leaves one open: then what depends on it is not known either.
template <class ForceOf>
std::optional<Vec3> borne_force(const std::optional<CentralHinge>& hinge,
                                CouplingId coupling,
                                const ForceOf& force_of) {
  const std::optional<Vec3> own = force_of(coupling);
  if (!own) {
    return std::nullopt;
  }
  Vec3 with_planets = *own;
  for (std::size_t i = 0; hinge && i < hinge->planets.size(); ++i) {
    const std::optional<Vec3> of_planet = force_of(hinge->planets[i].coupling);
    if (!of_planet) {
      return std::nullopt;
    }
    with_planets += hinge->planets[i].sign * *of_planet;
  }
  return borne(hinge, *own, with_planets);
}

}  // namespace kinestat
