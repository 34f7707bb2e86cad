// Which instantaneous freedoms persist when the mechanism moves, and whether the drawn position is
// singular.
#pragma once

#include <span>
#include <vector>

#include "studies/mobility/motion_space.hpp"
#include "studies/motion/motion_network.hpp"

namespace kinestat {

/// What becomes of one instantaneous motion.
enum class Persistence {
  finite,        ///< the mechanism goes along it
  deflected,     ///< it moves, but not in this direction: the drawn position is singular
  instantaneous  ///< nothing closes near it: a mechanism that shakes
};

/// "finite", "deflected", "instantaneous"
std::string_view word_of(Persistence persistence);

struct FreedomTrial {
  Persistence persistence = Persistence::finite;
  double step = 0.0;  ///< how far it was followed: largest turn [rad], or slide as share of
                      ///< the mechanism's size; further where the conditions of closure depend on
                      ///< each other
  double closure_error = 0.0;  ///< what is left after closing, as share of the size
};

struct FiniteMobility {
  bool is_known = true;              ///< no coupling lacks a finite law
  std::vector<FreedomTrial> trials;  ///< one a motion
  int drawn_freedom = 0;             ///< instantaneous, in the drawn position
  int nearby_freedom = 0;            ///< the least at nearby positions on a motion; 0 if none moves
  std::vector<CouplingId> gained;    ///< couplings that move in the drawn position only

  bool is_singular() const { return is_known && nearby_freedom < drawn_freedom; }
};

/// `motions` are those of mobility (MotionSpace), at the drawn position; the network must be made
/// without drives, otherwise nothing is known.
[[nodiscard]] FiniteMobility find_finite_mobility(const MotionNetwork& network,
                                                  const Mechanism& mechanism,
                                                  std::span<const FreeMotion> motions);

}  // namespace kinestat
