// The numbers of a synthesis task: positions, limits.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "studies/synthesis/dyads/dyad_choice.hpp"
#include "studies/synthesis/dyads/given_dyad.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"
#include "studies/synthesis/selection/selection.hpp"
#include "studies/synthesis/synthesis.hpp"
#include "studies/synthesis/task/task_positions.hpp"

namespace kinestat {

/// A task of this file with what was found for it: dyads, linkages and curves, by the number of its
/// positions. Three and four positions have the dyads that are given, if any. With a function,
/// which stands in the limits, the positions are those seen_from_output, and the dyads its cranks.
SynthesisTask solve_task(std::vector<PositionJets> positions,
                         const LinkageLimits& limits,
                         const LastDecimal& decimal = {},
                         const std::vector<Dyad>& given = {});

/// Dyads of few positions that are given or chosen, with the digits of their curves if they have
/// any, and their linkages.
void add_dyads(std::vector<Dyad> dyads,
               const std::optional<FourPositionCurves>& curves,
               const LinkageLimits& limits,
               SynthesisTask& task);

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

  /// The dyads that the file gives: for one choice of angles. Empty iff an error was added: E0305
  /// for a point with which there is no dyad, E0303 for one that two positions need beside it. With
  /// a function they are the cranks of a coupler.
  std::optional<std::vector<Dyad>> given_dyads(std::span<const PositionJets> positions,
                                               Diagnostics& found) const;

  /// The ranges of `vary` by its numbers, two for a point; none where dyads are chosen.
  std::vector<SelectionRange> ranges() const;

  /// Where circle points, or centre points, may lie, if dyads are chosen.
  std::optional<ChoiceArea> choice_area() const;

  /// How many combinations a selection tries, about.
  int samples() const;

  /// What one number for each of those ranges means.
  SynthesisChoice choice_of(std::span<const double> numbers) const;

  LinkageLimits limits() const;
  std::optional<int> curve_count() const;

  /// Decimal digits that the file asks for.
  std::optional<int> digits() const;

 private:
  std::optional<AngleFunction> function() const;
  std::optional<std::vector<Dyad>> given_cranks(std::span<const PositionJets> positions,
                                                Diagnostics& found) const;
  double number(const Value& value, QuantityKind kind) const;
  Point point(const std::vector<Value>& coordinates) const;
  std::optional<PlaneArea> area(const std::optional<AreaDescription>& area) const;
  GivenDyad given(const DyadDescription& dyad) const;

  const MechanismDescription& description_;
  const SynthesisDescription& task_;
  TaskPositions<double> positions_;
};

}  // namespace kinestat
