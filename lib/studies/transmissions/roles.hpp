// Which terminal of a planetary set is sun, carrier and ring, and which sets are of which kind.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "studies/transmissions/structure.hpp"

namespace kinestat {

enum class SetKind : std::uint8_t {
  simple,        ///< i0 = -z_ring/z_sun
  double_planet  ///< i0 = z_ring/z_sun: planets in pairs
};

/// Which of the three shafts of a set, by its place, is its sun, its carrier, its ring.
struct SetRoles {
  std::uint8_t sun = 0;
  std::uint8_t carrier = 1;
  std::uint8_t ring = 2;

  bool operator==(const SetRoles&) const = default;
};

inline constexpr int kRolesOfSet = 6;

/// The roles by their number below kRolesOfSet.
SetRoles set_roles(int number);

/// Roles and kinds of all sets: the sets of a number to the base 6, the first the last digit, and
/// the double-planet ones as bits.
struct RoleChoice {
  std::uint32_t roles = 0;
  std::uint32_t double_planet = 0;

  auto operator<=>(const RoleChoice&) const = default;

  int roles_of(int set) const;
  SetKind kind_of(int set) const;
};

/// How one automorphism of a structure moves what belongs to its sets.
class SetAction {
 public:
  SetAction(const TransmissionStructure& structure, const VertexMap& automorphism);

  int set_of(int set) const { return sets_[static_cast<std::size_t>(set)]; }

  RoleChoice image(const RoleChoice& choice) const;

 private:
  int count_;
  std::array<int, kMostGearSets> sets_{};
  std::array<std::array<std::uint8_t, kRolesOfSet>, kMostGearSets> roles_{};  // by set and number
};

/// All choices of roles with so many double-planet sets that are the least of those into which
/// the automorphisms take them.
std::vector<RoleChoice> least_role_choices(int sets,
                                           int double_planet,
                                           const std::vector<SetAction>& automorphisms);

/// Whether no automorphism takes the choice to a lesser one.
bool is_least(const RoleChoice& choice, const std::vector<SetAction>& automorphisms);

}  // namespace kinestat
