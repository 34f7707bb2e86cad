// Random mechanisms from a seed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "support/random_network_plan.hpp"

namespace kinestat {

struct NetworkActuator {
  std::string name;
  int coupling = 0;  ///< number of it
  int freedom = 0;   ///< number among those of the coupling
};

/// What a file would say. Bodies are b0 (the ground), b1, …; `body_order` is the order of the
/// moving ones in the file.
struct RandomNetwork {
  Layout layout = Layout::general;
  std::vector<int> body_order;
  std::vector<NetworkCoupling> couplings;
  std::vector<NetworkActuator> actuators;
  std::vector<std::string> tree;  ///< empty: the default one
  /// Actuators or `passive:` name screws along the axes of the world, which do not turn with it.
  bool names_world = false;

  Space space() const { return layout == Layout::planar ? Space::planar : Space::spatial; }

  int body_count() const { return static_cast<int>(body_order.size()) + 1; }
};

/// A network of at least one circuit. Even seeds have passive couplings with f + c = λ alone (and
/// actuators); odd seeds also rolling teeth, clutches, brakes and `passive:`.
RandomNetwork make_random_network(std::uint64_t seed);

/// The text of the mechanism file.
std::string to_yaml(const RandomNetwork& network);

/// The names of freedoms and constraints that the binder gives to the couplings that are named.
void update_names(RandomNetwork& network);

/// Through the reader and the binder; a complaint of either is a failed test and an empty
/// mechanism.
Mechanism bind_network(const RandomNetwork& network);

}  // namespace kinestat
