// What springs do in a position.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "dynamics/load_state.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

struct SpringState {
  double position = 0.0;  ///< length, or position of the freedom [m or rad]
  double rate = 0.0;
  double force = 0.0;  ///< tension [N]; of a freedom the action of tail on head [N or N·m]
};

/// A spring of which nothing can be said.
struct SpringObstacle {
  enum class Kind {
    no_length,    ///< its points meet, so that it has no direction
    past_stroke,  ///< a gas spring is shorter or longer than it can be
    no_position   ///< of a freedom without a position
  };

  Kind kind = Kind::no_length;
  std::size_t spring = 0;
};

/// Of each spring of a mechanism that stands there; `forces` are what each has beside stiffness and
/// damping (curve_numbers).
std::variant<std::vector<SpringState>, SpringObstacle> spring_states(
    const Mechanism& drawn, const LoadState& place, std::span<const double> forces);

/// What the stiffness or the gas of a spring holds at that length or position [J]; none where they
/// act not.
double stored_energy(const Spring& spring, double position);

/// How that grows with the position: the tension without damping [N], or minus the action of a
/// freedom [N or N·m].
double elastic_tension(const Spring& spring, double position);

/// Their forces on the bodies they join, as loads spring.NAME, or spring.NAME.BODY where both move;
/// the names are `spring_load_names`, in that order.
/// `moved` has the screws of the position.
std::vector<Load> spring_loads(const Mechanism& moved,
                               const LoadState& place,
                               const std::vector<SpringState>& states);

std::vector<std::string> spring_load_names(const Mechanism& mechanism);

}  // namespace kinestat
