#include "couplings/coupling_upgrade.hpp"

#include "couplings/kinds.hpp"
#include "couplings/mechanics.hpp"

namespace kinestat {

std::vector<CouplingUpgrade> coupling_upgrades(CouplingType type,
                                               std::span<const Twist> freedoms,
                                               const Vec3& point) {
  const FindUpgrades find = kind_of(type).mechanics->upgrades;
  return find != nullptr ? find(freedoms, point) : std::vector<CouplingUpgrade>();
}

}  // namespace kinestat
