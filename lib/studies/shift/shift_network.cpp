#include "studies/shift/shift_network.hpp"

#include <cmath>

#include "core/tolerance.hpp"
#include "math/elimination/elimination.hpp"
#include "network/node_system.hpp"

namespace kinestat {

namespace {

// Motions with what each of their entries may be off by: every one is made of sums in which the
// largest may have cancelled.
class BoundedMotions {
 public:
  explicit BoundedMotions(std::vector<VecX> motions) : motions_(std::move(motions)) {
    for (const VecX& motion : motions_) {
      bounds_.push_back(kCancellation * motion.lpNorm<Eigen::Infinity>());
    }
  }

  std::size_t count() const { return motions_.size(); }

  // Of each motion one entry, times `unit`.
  RateRow row(Eigen::Index entry, double unit) const {
    RateRow row;
    for (std::size_t j = 0; j < motions_.size(); ++j) {
      const double value = motions_[j][entry];
      row.push_back(std::abs(value) <= bounds_[j]
                        ? BoundedNumber{}
                        : BoundedNumber{.value = unit * value, .bound = unit * bounds_[j]});
    }
    return row;
  }

 private:
  std::vector<VecX> motions_;
  std::vector<double> bounds_;
};

std::vector<RateRow> rates_of(const Mechanism& mechanism,
                              const CoordinateBasis& basis,
                              const std::vector<int>& actuators,
                              const BoundedMotions& motions) {
  const Topology& topology = mechanism.topology;
  std::vector<RateRow> rows;
  for (const int actuator : actuators) {
    const int freedom = topology.actuators[static_cast<std::size_t>(actuator)].freedom;
    rows.push_back(motions.row(velocity_column(topology, basis, freedom),
                               rate_unit(topology, basis, freedom)));
  }
  return rows;
}

template <class List, class Projection>
std::vector<int> actuators_of(const List& list, Projection actuator) {
  std::vector<int> actuators;
  for (const auto& one : list) {
    actuators.push_back(one.*actuator);
  }
  return actuators;
}

}  // namespace

ShiftNetwork make_shift_network(const Mechanism& mechanism,
                                const CoordinateBasis& basis,
                                const ShiftPlan& plan) {
  const Elimination elimination(velocity_system(mechanism.topology, mechanism.geometry, basis), {});
  const BoundedMotions motions(elimination.null_vectors());
  const auto rates = [&](const std::vector<int>& actuators) {
    return rates_of(mechanism, basis, actuators, motions);
  };
  ShiftNetwork network{.motions = static_cast<int>(motions.count()),
                       .inputs = rates(actuators_of(plan.inputs, &ShiftInput::actuator)),
                       .outputs = rates(plan.outputs),
                       .elements = rates(actuators_of(plan.elements, &ShiftElement::actuator)),
                       .others = rates(plan.others),
                       .bodies = {},
                       .order = basis.order()};
  const Eigen::Index rows = basis.order() * (mechanism.topology.body_count() - 1);
  for (Eigen::Index row = 0; row < rows; ++row) {
    network.bodies.push_back(motions.row(row, 1.0));
  }
  return network;
}

}  // namespace kinestat
