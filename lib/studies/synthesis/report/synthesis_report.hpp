// The answers to the synthesis task of one file in the forms of a report.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "report/report_forms.hpp"
#include "studies/synthesis/dyads/burmester.hpp"
#include "studies/synthesis/dyads/few_positions.hpp"
#include "studies/synthesis/positions/special_frame.hpp"
#include "studies/synthesis/positions/specification.hpp"
#include "studies/synthesis/selection/selection.hpp"
#include "studies/synthesis/synthesis.hpp"

namespace kinestat {

/// What a selection chose for the ranges of 'vary'.
struct SynthesisChoice {
  std::optional<double> m;
  std::optional<Point> free_point;
  std::optional<EffectiveFreedom> freedom;  ///< instead of both
};

/// Usable linkages of a kind that the file does not ask for.
struct LeftOutLinkages {
  LinkageType type = LinkageType::slider_crank;
  int usable = 0;
};

/// What a linkage does when it is moved as a mechanism, with the drive of its verdict.
struct LinkageCheck {
  std::vector<bool> reached;     ///< of each position: met before the drive comes to a limit
  bool passes_in_order = false;  ///< met one after the other in the sense of the verdict
  double worst = 0.0;            ///< how far a position is missed that the verdict promises: the
                                 ///< larger of distance by size and turn [rad]
  bool agrees = false;           ///< with the verdict
};

/// One choice of the angles that a file lists, and of its ranges, and what was found for it.
/// Lengths in SI.
struct SynthesisTask {
  std::optional<SynthesisChoice> choice;     ///< where the file has ranges
  std::vector<PositionJets> positions;       ///< with a function those seen_from_output
  std::optional<BurmesterSolution> dyads;    ///< of five positions; with a function its cranks
  std::optional<FourPositionCurves> curves;  ///< of four
  std::optional<Circle> straight_paths;      ///< of three
  Degeneracy special = Degeneracy::none;     ///< of two and three: why they leave more open
  std::vector<LinkageCandidate> linkages;    ///< the best first
  std::vector<LeftOutLinkages> left_out;     ///< usable ones of other kinds than were asked for
  std::vector<std::string> files;            ///< written, one a linkage; empty ones are not
  std::vector<std::optional<LinkageCheck>> checks;  ///< one a linkage, or none asked for

  /// Those of the coupler of one of its linkages.
  const std::vector<PositionJets>& positions_of(const LinkageCandidate& linkage) const {
    return linkage.positions.empty() ? positions : linkage.positions;
  }
};

/// A selection for one choice of the angles that a file lists.
struct AngleSelection {
  std::vector<double> angles;  ///< of all positions [rad]
  SelectionCounts counts;
  std::size_t first_task = 0;  ///< of those found for it
};

struct SynthesisAnalysis {
  std::string file;  ///< as the user gave it
  MechanismDescription description;
  int curve_count = kUsualCurvePoints;  ///< points of each curve
  std::optional<int> digits;            ///< decimal digits of the positions, if asked for
  std::string form;                     ///< "PP-PP-P"
  LinkageLimits limits;
  std::optional<SelectionCounts> selection;  ///< where the file has ranges
  std::vector<AngleSelection> selections;    ///< of which that is the sum
  std::vector<SynthesisTask> tasks;          ///< with ranges the best choices, perhaps none
};

/// The places, from 0, of the positions whose angle is a list: what tells the tasks of a file
/// apart.
std::vector<std::size_t> positions_with_lists(const SynthesisDescription& task);

/// Limits with which a linkage that passes the positions would be usable; those that it keeps to
/// are empty.
struct LimitsNeeded {
  std::optional<GrashofClass> grashof;      ///< empty also of what is no four-bar
  bool is_any_linkage = false;              ///< it is no four-bar: any class
  std::optional<LinkageCircuit> circuit;    ///< empty also of what has no crank
  bool is_any_circuit = false;              ///< it has no crank
  bool may_stop = false;                    ///< its input does not turn fully
  std::optional<double> outside;            ///< farthest of its points from its area [length]
  std::optional<double> transmission;       ///< [rad]
  std::optional<double> full_transmission;  ///< [rad]
  std::optional<double> ratio;
  std::optional<double> size;  ///< [length]
};

/// Empty where no limit helps, or none is needed.
std::optional<LimitsNeeded> find_limits_needed(const LinkageCandidate& candidate);

FileReport make_synthesis_report(const SynthesisAnalysis& analysis,
                                 const ReportForms& forms,
                                 const Diagnostics& found);

}  // namespace kinestat
