// Freedoms that no other body feels: a rod that spins between two ball joints.
#pragma once

#include <span>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// Some bodies that turn or shift while all others rest: only the couplings between the two move,
/// and these join them to two bodies at least. So neither of them feels it.
struct PassiveFreedom {
  std::vector<BodyId> bodies;  ///< those that move
  std::vector<Twist> twists;   ///< of each of them [SI]
  VecX rates;                  ///< one a freedom of the mechanism [SI]; 0 of those that it rests in

  bool moves(int freedom) const { return rates[freedom] != 0.0; }

  /// Whether it turns a body, in a mechanism of that length.
  bool turns(BodyId body, double length) const;

  /// Whether it moves a point of a body [m], drawn there.
  bool moves_point(BodyId body, const Vec3& drawn, double length) const;
};

/// Those of single bodies and of short chains of bodies with two couplings each, which do not
/// follow from each other. What an actuator moves is felt, and so is a coupling of one freedom that
/// a case drives or holds. Those of the same bodies turn or shift them as one.
std::vector<PassiveFreedom> find_passive_freedoms(const Mechanism& mechanism,
                                                  const CoordinateBasis& basis);

/// What is left of them where some freedoms have given rates: a basis of the motions that they are
/// made of and in which these freedoms rest, whatever basis they are.
std::vector<PassiveFreedom> passive_freedoms_beside(std::vector<PassiveFreedom> passive,
                                                    const Mechanism& mechanism,
                                                    std::span<const int> given);

/// One freedom of each of them that does not follow from those before, which it turns or shifts
/// fastest beside these: where they have rates, all is known of them.
std::vector<int> deciding_freedoms(const std::vector<PassiveFreedom>& passive,
                                   const Mechanism& mechanism);

/// Whether it turns a load that is fixed to its body (LoadFrame::body), whose direction then
/// follows from where the freedom stands.
bool turns_load(const PassiveFreedom& one, const Case& which);

}  // namespace kinestat
