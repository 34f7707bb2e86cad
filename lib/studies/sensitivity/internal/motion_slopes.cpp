#include "studies/sensitivity/internal/motion_slopes.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/index.hpp"
#include "couplings/finite_law.hpp"
#include "mechanism/gears/mesh.hpp"
#include "network/bases.hpp"
#include "network/node_system.hpp"
#include "studies/sensitivity/internal/case_equations.hpp"
#include "studies/sensitivity/internal/change.hpp"
#include "studies/sensitivity/internal/screw_slopes.hpp"

namespace kinestat {

namespace {

constexpr double kNoSlope = std::numeric_limits<double>::quiet_NaN();

// How a screw that is fixed in a body with that twist changes.
TwistOf<Dual> carried(const TwistOf<Dual>& body, const TwistOf<Dual>& screw) {
  return {.angular = body.angular.cross(screw.angular),
          .linear = body.linear.cross(screw.angular) + body.angular.cross(screw.linear)};
}

// Accelerations leave the subspace in which velocities may lie.
CoordinateBasis whole_basis(const Mechanism& mechanism) {
  const bool is_planar =
      mechanism.space == Space::planar && mechanism.kinematic_order != OrderChoice::spatial;
  return is_planar ? planar_basis(ScrewKind::twist, mechanism.geometry.length)
                   : spatial_basis(ScrewKind::twist, mechanism.geometry.length);
}

class MotionDifferentiator {
 public:
  explicit MotionDifferentiator(const DualCase& values)
      : values_(values),
        topology_(values.topology()),
        equations_(motion_equations(
            values.mechanism(), values.which(), whole_basis(values.mechanism()))) {}

  MotionSlopes velocities() {
    MotionSlopes result;
    if (values_.motion() == nullptr) {
      return result;
    }
    result.rates = solved(values_.motion()->rates, motion_changes(values_, equations_.basis()));
    for (std::size_t e = 0; e < topology_.couplings.size(); ++e) {
      couplings_.push_back(sum_over(e, result.rates));
    }
    result.twists = on_bodies(couplings_);
    return result;
  }

  AccelerationSlopes accelerations() {
    AccelerationSlopes result{.motion = velocities(), .without_law = {}};
    const std::vector<Mesh> meshes = find_meshes(topology_, values_.mechanism().geometry);
    std::vector<TwistOf<Dual>> turning;  // of each coupling, with steady rates
    for (std::size_t e = 0; e < topology_.couplings.size(); ++e) {
      std::optional<TwistOf<Dual>> steady = steady_change(e, meshes, result.motion);
      if (!steady) {
        result.without_law = CouplingId{static_cast<int>(e)};
        return result;
      }
      turning.push_back(*std::move(steady));
    }
    const std::vector<Dual> speeding_up = solve_rates(turning);
    for (std::size_t e = 0; e < turning.size(); ++e) {
      turning[e] = turning[e] + sum_over(e, speeding_up);
    }
    result.motion.twist_rates = on_bodies(turning);
    return result;
  }

 private:
  const TwistOf<Dual>& unit(int freedom) const {
    return values_.derivatives().geometry.motions[at(freedom)];
  }

  TwistOf<Dual> sum_over(std::size_t e, const std::vector<Dual>& rates) const {
    const CouplingTopology& edge = topology_.couplings[e];
    TwistOf<Dual> sum;
    for (int f = edge.first_freedom; f < edge.first_freedom + edge.freedom_count; ++f) {
      sum = sum + rates[at(f)] * unit(f);
    }
    return sum;
  }

  std::vector<TwistOf<Dual>> on_bodies(const std::vector<TwistOf<Dual>>& couplings) const {
    std::vector<TwistOf<Dual>> bodies;
    for (std::size_t b = 0; b < topology_.bodies.size(); ++b) {
      bodies.push_back(values_.along_tree(b, [&](std::size_t e) { return couplings[e]; }));
    }
    return bodies;
  }

  // Σ φ V x $; empty where nobody knows which body carries its screws.
  std::optional<TwistOf<Dual>> steady_change(std::size_t e,
                                             const std::vector<Mesh>& meshes,
                                             const MotionSlopes& motion) const {
    const CouplingTopology& edge = topology_.couplings[e];
    const FiniteLaw law =
        finite_law(edge.type, values_.mechanism().space, values_.mechanism().drawn_couplings[e]);
    TwistOf<Dual> sum;
    if (law.kind == LawKind::rolling) {
      const auto mesh = std::ranges::find(meshes, CouplingId{static_cast<int>(e)}, &Mesh::coupling);
      if (mesh == meshes.end() || !mesh->carrier) {
        return std::nullopt;
      }
      return carried(motion.twists[at(mesh->carrier->value)], couplings_[e]);
    }
    if (law.kind != LawKind::chain) {
      return std::nullopt;
    }
    TwistOf<Dual> carrier = motion.twists[at(edge.tail.value)];
    for (const ElementaryMotion& part : law.chain) {
      const int first = edge.first_freedom + part.freedom;
      TwistOf<Dual> moved;
      for (int f = first; f < first + (part.kind == ElementaryKind::ball ? 3 : 1); ++f) {
        moved = moved + motion.rates[at(f)] * unit(f);
      }
      sum = sum + carried(carrier, moved);
      carrier = carrier + moved;
    }
    return sum;
  }

  // Values and slopes; no slope where the redundant equations forbid one.
  std::vector<Dual> solved(const std::vector<double>& rates, const std::vector<Change>& changes) {
    std::vector<Dual> result(rates.begin(), rates.end());
    for (Dual& one : result) {
      one.derivatives.assign(changes.size(), 0.0);
    }
    is_possible_.resize(changes.size(), true);
    for (std::size_t p = 0; p < changes.size(); ++p) {
      is_possible_[p] = is_possible_[p] && equations_.allows(changes[p]);
      if (changes[p].is_nothing() && is_possible_[p]) {
        continue;
      }
      const std::vector<double> slopes =
          is_possible_[p] ? equations_.solve(changes[p]) : std::vector<double>();
      for (std::size_t f = 0; f < result.size(); ++f) {
        result[f].derivatives[p] = is_possible_[p] ? slopes[f] : kNoSlope;
      }
    }
    return result;
  }

  void add_coordinate(Change& change, std::size_t e, int i, double value) const {
    const CoordinateBasis& basis = equations_.basis();
    const int first = basis.order() * static_cast<int>(e);
    for (int r = 0; r < basis.order(); ++r) {
      if (basis.basis(i, r) != 0.0) {
        change.rows.emplace_back(first + r, basis.basis(i, r) * value / basis.unit[i]);
      }
    }
  }

  // The φ' that make the couplings change so and fit together, as the case speeds up.
  std::vector<Dual> solve_rates(const std::vector<TwistOf<Dual>>& turning) {
    const std::size_t count = values_.parameter_count();
    const std::vector<Primary>& given = values_.which().motions;
    const std::vector<Dual>& given_rates = values_.primaries().accelerations;
    Change value;
    std::vector<Change> changes(count);
    for (std::size_t i = 0; i < given.size(); ++i) {
      const double per = rate_unit(topology_, equations_.basis(), given[i].index);
      value.known.push_back(given_rates[i].value / per);
      for (std::size_t p = 0; p < count; ++p) {
        changes[p].known.push_back(derivative(given_rates[i], p) / per);
      }
    }
    for (std::size_t e = 0; e < turning.size(); ++e) {
      const Vec6Of<Dual> coordinates = turning[e].coordinates();
      for (int i = 0; i < 6; ++i) {
        add_coordinate(value, e, i, coordinates[i].value);
        for (std::size_t p = 0; p < count; ++p) {
          const double slope = derivative(coordinates[i], p);
          if (slope != 0.0 && is_possible_[p]) {
            add_coordinate(changes[p], e, i, slope);
          }
        }
      }
    }
    const std::vector<double> rates = equations_.solve(value);
    for (std::size_t f = 0; f < rates.size(); ++f) {
      const auto e = at(topology_.freedoms[f].coupling.value);
      for_each_slope(unit(static_cast<int>(f)), [&](std::size_t p, int i, double slope) {
        add_coordinate(changes[p], e, i, rates[f] * slope);
      });
    }
    return solved(rates, changes);
  }

  const DualCase& values_;
  const Topology& topology_;
  FactoredSide equations_;
  std::vector<bool> is_possible_;         // of each parameter
  std::vector<TwistOf<Dual>> couplings_;  // head relative to tail
};

}  // namespace

MotionSlopes velocity_slopes(const DualCase& values) {
  return MotionDifferentiator(values).velocities();
}

AccelerationSlopes acceleration_slopes(const DualCase& values) {
  return MotionDifferentiator(values).accelerations();
}

}  // namespace kinestat
