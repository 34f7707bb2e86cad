// The numbers of a synthesis task: positions, limits.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "expression/parameters.hpp"
#include "report/synthesis_report.hpp"
#include "synthesis/selection.hpp"
#include "synthesis/specification.hpp"
#include "synthesis/synthesis.hpp"

namespace kinestat {

/// Values of the section `synthesis` of a description that is right by itself (check).
class SynthesisValues {
 public:
  explicit SynthesisValues(const MechanismDescription& description);

  /// One task for every choice of the angles that are lists, the last position's first. `choice`
  /// stands for what the curvature of a position leaves to the ranges. Empty iff an error was
  /// added: E0801 for a position that contradicts itself or at which nothing moves.
  std::optional<std::vector<std::vector<PositionJets>>> positions_of_tasks(
      const SynthesisChoice& choice, Diagnostics& found) const;

  /// The ranges of `vary`: m, then both coordinates of the free point.
  std::vector<SelectionRange> ranges() const;

  /// What one number for each of those ranges means.
  SynthesisChoice choice_of(std::span<const double> numbers) const;

  LinkageLimits limits() const;
  std::optional<int> curve_count() const;

 private:
  double number(const Value& value, QuantityKind kind) const;
  Point point(const PointDescription& point) const;
  std::optional<PositionJets> position(std::size_t index,
                                       double angle,
                                       const SynthesisChoice& choice,
                                       Diagnostics& found) const;
  PositionJets with_derivatives(const PositionDescription& position, double angle) const;

  const MechanismDescription& description_;
  const SynthesisDescription& task_;
  ParameterTable table_;
};

}  // namespace kinestat
