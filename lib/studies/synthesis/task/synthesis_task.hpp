// The numbers of a synthesis task: positions, limits.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "studies/synthesis/dyads/circle_point_choice.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"
#include "studies/synthesis/selection/selection.hpp"
#include "studies/synthesis/synthesis.hpp"
#include "studies/synthesis/task/task_positions.hpp"

namespace kinestat {

/// A task of this file with what was found for it: dyads, linkages and curves, by the number of its
/// positions.
SynthesisTask solve_task(std::vector<PositionJets> positions,
                         const LinkageLimits& limits,
                         const LastDecimal& decimal = {});

/// Values of the section `synthesis` of a description that is right by itself (check).
class SynthesisValues {
 public:
  explicit SynthesisValues(const MechanismDescription& description);

  /// See TaskPositions.
  std::optional<std::vector<std::vector<PositionJets>>> positions_of_tasks(
      const SynthesisChoice& choice, Diagnostics& found) const;

  /// See TaskPositions.
  std::optional<std::vector<PositionJets>> positions_of_task(std::size_t task,
                                                             const SynthesisChoice& choice,
                                                             Diagnostics& found) const;

  /// The ranges of `vary` by its numbers, two for a point; none where circle points are free.
  std::vector<SelectionRange> ranges() const;

  /// Where circle points may lie, if they are free.
  std::optional<CirclePointArea> circle_points() const;

  /// How many combinations a selection tries, about.
  int samples() const;

  /// What one number for each of those ranges means.
  SynthesisChoice choice_of(std::span<const double> numbers) const;

  LinkageLimits limits() const;
  std::optional<int> curve_count() const;

  /// Decimal digits that the file asks for.
  std::optional<int> digits() const;

 private:
  double number(const Value& value, QuantityKind kind) const;

  const SynthesisDescription& task_;
  TaskPositions<double> positions_;
};

}  // namespace kinestat
