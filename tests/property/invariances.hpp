// What must not change the answers of a network; each fails the running test.
#pragma once

#include "property/identities.hpp"
#include "support/random_network_changes.hpp"

namespace kinestat {

/// One solution of each side of a network. The sizes are those of its largest magnitudes: screws
/// may cancel within couplings.
struct Answers {
  std::vector<Primary> motions;  ///< the primary ones; empty where others are to be chosen
  Mat6X twists;                  ///< of each coupling
  double rate_size = 0.0;
  Mat6X wrenches;  ///< of each coupling
  Mat6X internal;  ///< the part of each actuator
  double action_size = 0.0;
  double length = 1.0;  ///< size of the mechanism [m]
};

/// For random primaries.
Answers solve_both(const NetworkCase& network, std::uint64_t seed);

/// A network, its answers and the seed of its change.
struct Trial {
  const RandomNetwork& network;
  const Answers& answers;
  std::uint64_t seed = 0;
};

/// The answers stay.
void expect_answers_with_another_tree(const Trial& trial);
void expect_answers_with_renumbered_bodies(const Trial& trial);

/// Those of the reversed couplings change their signs.
void expect_answers_with_reversed_edges(const Trial& trial);

/// They move with the world. So do the twists of the bodies, and the minimal orders stay.
void expect_moved_answers(const Trial& trial);
void expect_moved_bodies(const Trial& trial, const NetworkCase& original);
void expect_orders_when_moved(const Trial& trial, const NetworkCase& original);

/// Rotations and forces stay, translations and moments grow with the lengths.
void expect_scaled_answers(const Trial& trial, double factor);

}  // namespace kinestat
