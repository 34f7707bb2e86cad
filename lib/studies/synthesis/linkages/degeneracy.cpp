#include "studies/synthesis/linkages/degeneracy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/synthesis_tolerance.hpp"
#include "core/tolerance.hpp"
#include "studies/synthesis/dyads/internal/condition_rows.hpp"
#include "studies/synthesis/positions/internal/jets.hpp"

namespace kinestat {

namespace {

bool is_translation(std::span<const PositionJets> positions) {
  return std::ranges::all_of(positions, [&](const PositionJets& position) {
    const bool stands =
        std::ranges::all_of(position.angle.begin() + 1, position.angle.end(), [](double rate) {
          return std::abs(rate) < kSameAngle;
        });
    return stands && std::abs(turn_between(positions[0].angle[0], position.angle[0])) < kSameAngle;
  });
}

using ConditionRow = std::array<double, 7>;

Point shift_of(const ConditionRow& row) {
  return {row[0], row[1]};
}

// Without a turn a row says d . (w - z) = d²/2, in homogeneous form with d in the first two columns
// and d²/2 in the last: all points have the same arm w - z, if there is one.
Degeneracy kind_of_translation(const std::vector<ConditionRow>& rows) {
  const ConditionRow& first = *std::ranges::max_element(
      rows, {}, [](const ConditionRow& row) { return std::abs(shift_of(row)); });
  const Point one = shift_of(first);
  const ConditionRow& second = *std::ranges::max_element(
      rows, {}, [&](const ConditionRow& row) { return std::abs(cross(one, shift_of(row))); });
  const Point other = shift_of(second);
  const double area = cross(one, other);
  if (!(std::abs(area) > kRankZero)) {
    // On one line: the same distance asks for the same place, which would be there twice.
    const bool is_one_place = std::ranges::all_of(rows, [&](const ConditionRow& row) {
      return std::abs(first[6] * dot(one, shift_of(row)) - row[6] * std::norm(one)) < kRankZero;
    });
    return is_one_place ? Degeneracy::none : Degeneracy::straight_translation;
  }
  // The arm by Cramer's rule, times the area.
  const Point arm(first[6] * other.imag() - second[6] * one.imag(),
                  second[6] * one.real() - first[6] * other.real());
  const bool is_circle = std::ranges::all_of(rows, [&](const ConditionRow& row) {
    const double miss = dot(shift_of(row), arm) - row[6] * area;
    return std::abs(miss) < kRankZero * (std::abs(arm) + std::abs(area));
  });
  return is_circle ? Degeneracy::parallelogram : Degeneracy::translation;
}

}  // namespace

std::string_view word_of(Degeneracy reason) {
  switch (reason) {
    case Degeneracy::none:
      return "none";
    case Degeneracy::translation:
      return "translation";
    case Degeneracy::parallelogram:
      return "parallelogram";
    case Degeneracy::straight_translation:
      return "straight_translation";
    case Degeneracy::repeated_position:
      return "repeated_position";
    case Degeneracy::dependent:
      return "dependent_positions";
    case Degeneracy::straight_paths:
      return "straight_paths";
    case Degeneracy::sliding_lines:
      return "sliding_lines";
    case Degeneracy::shared_line:
      return "shared_line";
    case Degeneracy::shared_conic:
      return "shared_conic";
  }
  return "";
}

bool is_same_pose(const PositionJets& one, const PositionJets& other) {
  const std::array<PositionJets, 2> pair = {finite_position(origin(one), one.angle[0]),
                                            finite_position(origin(other), other.angle[0])};
  const ConditionRows system = make_condition_rows(std::span<const PositionJets>(pair));
  return std::ranges::all_of(system.rows[0], [](double entry) { return entry == 0.0; });
}

Degeneracy find_degeneracy(std::span<const PositionJets> positions) {
  for (std::size_t i = 0; i < positions.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (is_same_pose(positions[i], positions[j])) {
        return Degeneracy::repeated_position;
      }
    }
  }
  const ConditionRows system = make_condition_rows(positions);
  return !system.rows.empty() && is_translation(positions) ? kind_of_translation(system.rows)
                                                           : Degeneracy::none;
}

}  // namespace kinestat
