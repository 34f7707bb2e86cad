// What reports say of springs in a case.
#pragma once

#include "dynamics/spring_force.hpp"
#include "mechanism/springs/spring_quantities.hpp"
#include "record/record.hpp"

namespace kinestat {

struct SpringView {
  const Mechanism& mechanism;
  std::size_t index = 0;
  const SpringState& state;

  const Spring& spring() const { return mechanism.springs[index]; }

  bool turns() const { return is_about_turn(spring(), mechanism.topology); }
};

const Record<SpringView>& spring_record();

}  // namespace kinestat
