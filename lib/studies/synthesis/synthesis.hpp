// Every linkage of the dyads that were found, judged and ranked.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "studies/synthesis/dyads/burmester.hpp"
#include "studies/synthesis/linkages/cognates.hpp"
#include "studies/synthesis/linkages/defects.hpp"
#include "studies/synthesis/linkages/function_generator.hpp"
#include "studies/synthesis/linkages/linkage.hpp"
#include "studies/synthesis/linkages/verdict.hpp"
#include "studies/synthesis/positions/plane_area.hpp"

namespace kinestat {

/// What a linkage must keep to.
struct LinkageLimits {
  std::optional<LinkageType> type = std::nullopt;  ///< others are not looked at
  double transmission = 0.0;       ///< least margin of the transmission angle on the way [rad]
  double full_transmission = 0.0;  ///< likewise wherever the input can go
  double ratio = std::numeric_limits<double>::infinity();  ///< longest by shortest link
  double size = std::numeric_limits<double>::infinity();   ///< longest link [length]
  std::vector<GrashofClass> classes = {};                  ///< of a four-bar; empty: any linkage
  std::vector<LinkageCircuit> circuits = {};               ///< empty: any linkage
  bool turns_fully = false;                                ///< the input meets no dead point
  std::optional<AngleFunction> function = std::nullopt;    ///< of its cranks, the first driven
  std::optional<PlaneArea> circle_points = std::nullopt;   ///< where they lie, moving frame
  std::optional<PlaneArea> centre_points = std::nullopt;   ///< where they lie, fixed frame
};

/// How far such a point of a dyad lies outside the area of the limits [length]; zero without one,
/// and of a point at infinity.
double distance_outside(const Dyad& dyad, DyadPoint which, const LinkageLimits& limits);

/// What linkages are ranked by.
struct Standing {
  int rank = -1;  ///< highest without defects; then what misses fewer limits, of these what misses
                  ///< later ones in the list; then what does not pass the positions, likewise
  double margin = 0.0;  ///< of the transmission angle on the working arc [rad]

  Standing() = default;

  Standing(const Defects& defects, const DriveVerdict& verdict);

  bool is_better_than(const Standing& other) const;
};

struct LinkageCandidate {
  Linkage linkage;
  std::array<std::size_t, 2> dyads{};   ///< which of the given dyads
  std::vector<PositionJets> positions;  ///< of the coupler of a function generator; else empty
  std::optional<FourBarLengths> lengths;
  std::optional<Grashof> grashof;
  std::optional<LinkageCircuit> circuit;  ///< with the best drive; of what has a crank and passes
                                          ///< the positions in one
  std::optional<Cognates> cognates;       ///< for the path of the origin of the moving frame
  std::array<DriveVerdict, 2> verdicts;
  Drive best_drive = Drive::one;
  double longest = 0.0;  ///< of the links that have a length [length]
  double ratio = 1.0;    ///< longest by shortest of them
  double outside = 0.0;  ///< how far the farther of its points lies outside its area
  Defects defects;       ///< with the best drive

  /// The worst of them.
  Defect defect() const { return defects.worst(); }

  bool is_usable() const { return defects.is_empty(); }

  const DriveVerdict& best() const;

  /// The point of the coupler that is watched, in its frame: the origin; of a function generator
  /// the pivot on its input link.
  Point tracer() const { return positions.empty() ? Point(0.0, 0.0) : linkage.one.circle_point; }

  Standing standing() const { return {defects, best()}; }

  /// Of the transmission angle on the working arc of the best drive [rad]; zero if it has none.
  double margin() const;
};

/// All pairs of dyads, the best first: without defects, by the margin of the transmission angle;
/// then the others by their standing. Double dyads count once. With a function the dyads are those
/// of cranks_of_couplers, of which two that follow each other make a linkage, and have their own
/// positions.
std::vector<LinkageCandidate> rank_linkages(std::span<const Dyad> dyads,
                                            std::span<const PositionJets> positions,
                                            const LinkageLimits& limits);

}  // namespace kinestat
