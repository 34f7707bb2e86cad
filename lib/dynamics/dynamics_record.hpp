// What reports say of the inertia of the bodies in a case.
#pragma once

#include "dynamics/case_dynamics.hpp"
#include "record/record.hpp"

namespace kinestat {

struct DynamicsView {
  const Mechanism& mechanism;
  const CaseDynamics& dynamics;
};

const Record<DynamicsView>& dynamics_record();

}  // namespace kinestat
