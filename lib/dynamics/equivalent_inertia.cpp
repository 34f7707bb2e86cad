#include "dynamics/equivalent_inertia.hpp"

#include <algorithm>

#include "core/index.hpp"
#include "dynamics/body_inertia.hpp"

namespace kinestat {

std::optional<std::vector<double>> equivalent_inertias(const Mechanism& mechanism,
                                                       const KinematicSolution& motion,
                                                       int freedom) {
  const bool is_known = motion.status == SolveStatus::solved && motion.rates[at(freedom)] != 0.0 &&
                        std::ranges::any_of(mechanism.masses, &BodyMass::counts);
  if (!is_known) {
    return std::nullopt;
  }
  const double rate = motion.rates[at(freedom)];
  std::vector<double> inertias;
  for (std::size_t b = 0; b < mechanism.masses.size(); ++b) {
    if (mechanism.masses[b].counts() && !motion.knows_body(BodyId{static_cast<int>(b)})) {
      return std::nullopt;
    }
    const BodyInertia body = inertia_at(mechanism.masses[b], BodyPose{});
    inertias.push_back(2.0 * kinetic_energy(body, motion.bodies[b]) / (rate * rate));
  }
  return inertias;
}

}  // namespace kinestat
