#include "studies/sensitivity/adjoint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "network/bases.hpp"
#include "studies/sensitivity/internal/action_state.hpp"
#include "studies/sensitivity/internal/adjoint_side.hpp"
#include "studies/sensitivity/internal/case_equations.hpp"
#include "studies/sensitivity/internal/friction_slopes.hpp"
#include "studies/sensitivity/internal/screw_slopes.hpp"

namespace kinestat {

namespace {

bool is_zero(const std::vector<double>& slopes) {
  return std::ranges::all_of(slopes, [](double slope) { return slope == 0.0; });
}

// Whether parameters move only such coordinates of the screws as the basis has.
template <class Screw>
bool holds_slopes(const CoordinateBasis& basis, const std::vector<Screw>& screws) {
  std::array<bool, 6> is_moved{};
  for (const Screw& screw : screws) {
    for_each_slope(
        screw, [&](std::size_t, int i, double) { is_moved[static_cast<std::size_t>(i)] = true; });
  }
  for (int i = 0; i < 6; ++i) {
    if (is_moved[static_cast<std::size_t>(i)] && !basis.holds(Vec6::Unit(i))) {
      return false;
    }
  }
  return true;
}

// All coordinates of the space.
CoordinateBasis whole_basis(const Mechanism& mechanism, OrderChoice order, ScrewKind kind) {
  const bool is_planar = mechanism.space == Space::planar && order != OrderChoice::spatial;
  return is_planar ? planar_basis(kind, mechanism.geometry.length)
                   : spatial_basis(kind, mechanism.geometry.length);
}

CoordinateBasis motion_basis_for(const Mechanism& mechanism,
                                 const MechanismDerivatives& derivatives) {
  CoordinateBasis minimal = motion_basis(mechanism.geometry, mechanism.kinematic_order);
  return holds_slopes(minimal, derivatives.geometry.motions)
             ? minimal
             : whole_basis(mechanism, mechanism.kinematic_order, ScrewKind::twist);
}

CoordinateBasis action_basis_for(const Mechanism& mechanism,
                                 const MechanismDerivatives& derivatives) {
  std::vector<BodyWrench> loads;
  for (const Case& one : mechanism.cases) {
    std::ranges::copy(wrenches_of(one.loads), std::back_inserter(loads));
  }
  CoordinateBasis minimal = action_basis(mechanism.geometry, mechanism.static_order, loads);
  // Friction takes its direction from the motion.
  const bool is_enough = mechanism.frictions.empty() &&
                         holds_slopes(minimal, derivatives.geometry.actions) &&
                         std::ranges::all_of(derivatives.cases, [&](const CaseDerivatives& one) {
                           return holds_slopes(minimal, one.loads);
                         });
  return is_enough ? minimal : whole_basis(mechanism, mechanism.static_order, ScrewKind::wrench);
}

}  // namespace

AdjointBases find_adjoint_bases(const Mechanism& mechanism,
                                const MechanismDerivatives& derivatives) {
  return {.motion = motion_basis_for(mechanism, derivatives),
          .action = action_basis_for(mechanism, derivatives)};
}

CaseAdjoint::CaseAdjoint(const DualCase& values, const AdjointBases& bases)
    : values_(values), bases_(bases) {}

CaseAdjoint::~CaseAdjoint() = default;

AdjointSide& CaseAdjoint::motion() {
  if (!motion_) {
    ParameterChanges changes;
    changes.total = motion_changes(values_, bases_.motion);
    motion_ = std::make_unique<AdjointSide>(
        motion_equations(values_.mechanism(), values_.which(), bases_.motion), std::move(changes));
  }
  return *motion_;
}

AdjointSide& CaseAdjoint::action() {
  if (!action_) {
    action_ = std::make_unique<AdjointSide>(make_action());
  }
  return *action_;
}

AdjointSide CaseAdjoint::make_action() {
  FactoredSide equations = action_equations(values_.mechanism(), values_.which(), bases_.action);
  const ActionState state = find_action_state(values_, equations);
  ParameterChanges changes;
  changes.is_possible = values_.derivatives().starts_friction;
  changes.is_possible.flip();
  changes.total = known_action_changes(values_, bases_.action);
  add_action_changes(state.magnitudes, values_, bases_.action, changes.total);
  changes.open = state.stresses;
  changes.completed_count = state.completed_count;
  const Change nothing{.rows = {},
                       .known = std::vector<double>(values_.which().actions.size(), 0.0)};
  for (const std::vector<double>& open : changes.open) {
    changes.by_open.emplace_back(values_.parameter_count(), nothing);
    add_action_changes(open, values_, bases_.action, changes.by_open.back());
  }
  RateSlopes rates;
  for (std::size_t p = 0; friction_depends_on_rates(values_) && p < values_.parameter_count();
       ++p) {
    rates.push_back(motion().slopes_of(p));
  }
  add_open_frictions(values_, equations, rates, changes);
  friction_slopes_ = add_friction_changes(values_, equations, state.magnitudes, rates, changes);
  std::optional<Compatibility> compatibility;
  if (state.completed_count > 0) {
    compatibility.emplace(values_, equations, state.magnitudes, changes);
  }
  return {std::move(equations), std::move(changes), std::move(compatibility)};
}

void CaseAdjoint::add_frictions(const std::vector<double>& slopes,
                                std::vector<std::optional<Sum>>& result) {
  const AdjointSide& side = action();
  for (std::size_t p = 0; p < result.size(); ++p) {
    if (!side.is_possible(p)) {
      result[p] = std::nullopt;
    }
    for (std::size_t i = 0; result[p] && i < slopes.size(); ++i) {
      result[p]->add(slopes[i] * friction_slopes_[p][i]);
    }
  }
}

// A corner of the value towards one magnitude counts for those parameters that move the magnitude.
void CaseAdjoint::leave_corners(std::vector<double>& slopes,
                                std::vector<std::optional<Sum>>& result,
                                const AddPart& add_part) {
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    if (!std::isfinite(slopes[i])) {
      std::vector<double> alone(slopes.size(), 0.0);
      alone[i] = 1.0;
      std::vector<std::optional<Sum>> moved(result.size(), Sum{});
      add_part(alone, moved);
      for (std::size_t p = 0; p < result.size(); ++p) {
        if (!moved[p] || moved[p]->rounded() != 0.0) {
          result[p] = std::nullopt;
        }
      }
      slopes[i] = 0.0;
    }
  }
}

std::vector<std::optional<double>> CaseAdjoint::derivatives_of(const ReportedValue& value) {
  const Topology& topology = values_.topology();
  const auto slopes = [&](std::size_t first, std::size_t count) {
    std::vector<double> result(count);
    for (std::size_t i = 0; i < count; ++i) {
      result[i] = derivative(value.value, first + i);
    }
    return result;
  };
  const std::size_t rates = topology.freedoms.size();
  const std::size_t actions = topology.actions.size();
  const std::size_t frictions = values_.friction_count();
  std::vector<std::optional<Sum>> sums;
  const std::vector<bool>& breaks = values_.derivatives().breaks_coupling;
  for (const double direct : slopes(values_.first_parameter(), values_.parameter_count())) {
    const bool is_possible = !breaks[sums.size()];
    sums.push_back(is_possible ? std::optional(Sum{.value = direct, .size = std::abs(direct)})
                               : std::nullopt);
  }
  const auto add = [&](std::vector<double> by, const AddPart& add_part) {
    leave_corners(by, sums, add_part);
    if (!is_zero(by)) {
      add_part(by, sums);
    }
  };
  add(slopes(0, rates), [&](const auto& by, auto& result) { motion().add(by, result); });
  add(slopes(rates, actions), [&](const auto& by, auto& result) { action().add(by, result); });
  add(slopes(rates + actions, frictions),
      [&](const auto& by, auto& result) { add_frictions(by, result); });
  std::vector<std::optional<double>> result;
  for (const std::optional<Sum>& sum : sums) {
    const bool has_value = sum && std::isfinite(sum->value);
    result.push_back(has_value ? std::optional(sum->rounded()) : std::nullopt);
  }
  return result;
}

}  // namespace kinestat
