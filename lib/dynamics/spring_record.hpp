// What reports say of springs in a case.
#pragma once

#include "dynamics/spring_force.hpp"
#include "record/record.hpp"

namespace kinestat {

struct SpringView {
  const Mechanism& mechanism;
  std::size_t index = 0;
  const SpringState& state;

  const Spring& spring() const { return mechanism.springs[index]; }

  /// Whether it is about a freedom that turns.
  bool turns() const {
    return spring().is_of_freedom() &&
           mechanism.topology.freedoms[static_cast<std::size_t>(spring().freedom)].is_rotation;
  }
};

const Record<SpringView>& spring_record();

}  // namespace kinestat
