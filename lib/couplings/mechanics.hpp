// What follows from the kind of a coupling for the mechanics.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "couplings/coupling_upgrade.hpp"
#include "couplings/finite_law.hpp"
#include "math/numbers/exact_input.hpp"

namespace kinestat {

template <class Scalar>
class CatalogueRow;
class LawWriter;

/// Writes the row of the catalogue.
template <class Scalar>
using WriteScrews = void (*)(const CouplingGeometryOf<Scalar>&, CatalogueRow<Scalar>&);

/// The same for all scalars.
struct ScrewWriters {
  WriteScrews<double> of_double;
  WriteScrews<Dual> of_dual;
  WriteScrews<ExactInput> of_exact_input;

  template <class Scalar>
  WriteScrews<Scalar> of() const {
    if constexpr (std::same_as<Scalar, double>) {
      return of_double;
    } else if constexpr (std::same_as<Scalar, Dual>) {
      return of_dual;
    } else {
      return of_exact_input;
    }
  }
};

/// From a generic function.
constexpr ScrewWriters screws_by(auto write) {
  return {.of_double = write, .of_dual = write, .of_exact_input = write};
}

enum class Follows { world, tail, head, carrier, contact };

/// Whose rotation turns a screw in a moved position, and whose motion carries the point that it is
/// measured from.
struct Carried {
  Follows direction = Follows::tail;
  Follows point = Follows::tail;
};

inline constexpr Carried kWithTail;
inline constexpr Carried kWithHead = {.direction = Follows::head, .point = Follows::head};
inline constexpr Carried kWithCarrier = {.direction = Follows::carrier, .point = Follows::carrier};
inline constexpr Carried kWithContact = {.direction = Follows::contact, .point = Follows::contact};
inline constexpr Carried kAtContact = {.direction = Follows::world, .point = Follows::contact};
inline constexpr Carried kAtTail = {.direction = Follows::world, .point = Follows::tail};
inline constexpr Carried kHeadAtTail = {.direction = Follows::head, .point = Follows::tail};

/// What moves the place and the screws of a coupling.
struct CarriedParts {
  std::span<const Carried> freedoms = {};  ///< in the order of the catalogue, the last for all that
                                           ///< follow; empty: with the tail
  std::optional<Carried> turns = {};       ///< of those that turn, where only slides are as above
  Carried forces = kWithTail;
  Carried couples = kWithTail;
  bool couple_is_across_turns = false;  ///< of its first two freedoms, as they are moved
  Follows place = Follows::tail;
  bool are_found_anew = false;  ///< from where the ends are in the moved position

  Carried freedom(int index, bool is_rotation) const {
    if (is_rotation && turns) {
      return *turns;
    }
    const auto i = static_cast<std::size_t>(index);
    return freedoms.empty() ? kWithTail : i < freedoms.size() ? freedoms[i] : freedoms.back();
  }
};

using FindUpgrades = std::vector<CouplingUpgrade> (*)(std::span<const Twist> freedoms,
                                                      const Vec3& point);

struct KindMechanics {
  ScrewWriters screws;
  void (*law)(LawWriter& law) = nullptr;
  CarriedParts carried = {};
  FindUpgrades upgrades = nullptr;  ///< null: there are none
};

}  // namespace kinestat
