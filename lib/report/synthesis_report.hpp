// The answers to the synthesis task of one file in the forms of a report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/mechanism_description.hpp"
#include "report/file_report.hpp"
#include "synthesis/burmester.hpp"
#include "synthesis/few_positions.hpp"
#include "synthesis/special_frame.hpp"
#include "synthesis/specification.hpp"
#include "synthesis/synthesis.hpp"

namespace kinestat {

/// What a selection chose for the ranges of 'vary'.
struct SynthesisChoice {
  std::optional<double> m;
  std::optional<Point> free_point;
  std::optional<EffectiveFreedom> freedom;  ///< instead of both
};

/// One choice of the angles that a file lists, and of its ranges, and what was found for it.
/// Lengths in SI.
struct SynthesisTask {
  std::optional<SynthesisChoice> choice;  ///< where the file has ranges
  std::vector<PositionJets> positions;
  std::optional<BurmesterSolution> dyads;    ///< of five positions
  std::optional<FourPositionCurves> curves;  ///< of four
  std::optional<Circle> straight_paths;      ///< of three
  Degeneracy special = Degeneracy::none;     ///< of two and three: why they leave more open
  std::vector<LinkageCandidate> linkages;    ///< the best first
  std::vector<std::string> files;            ///< written, one a linkage; empty ones are not
};

/// What a selection looked at.
struct SelectionCounts {
  int samples = 0;
  int with_linkage = 0;
  int usable = 0;
};

struct SynthesisAnalysis {
  std::string file;  ///< as the user gave it
  MechanismDescription description;
  int curve_count = 200;                     ///< points of each curve
  std::optional<int> digits;                 ///< decimal digits of the positions, if asked for
  std::string form;                          ///< "PP-PP-P"
  std::optional<SelectionCounts> selection;  ///< where the file has ranges
  std::vector<SynthesisTask> tasks;          ///< with ranges the best choices, perhaps none
};

/// Lengths below this are rounding of the positions and reported as zero [m].
double zero_length(const SynthesisTask& task);

/// The same for the places of a dyad, which have fewer digits than the positions.
double zero_length(const Dyad& dyad);

FileReport make_synthesis_report(const SynthesisAnalysis& analysis,
                                 const ReportForms& forms,
                                 const Diagnostics& found);

}  // namespace kinestat
