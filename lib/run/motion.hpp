// Finite motions of the mechanisms of files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mechanism/motion_plan.hpp"
#include "motion/motion_solution.hpp"
#include "report/motion_table.hpp"
#include "run/analyse.hpp"

namespace kinestat {

/// What the command line says, before what the file says.
struct MotionChoice {
  std::optional<std::string> drive;
  std::optional<std::string> from;   ///< as typed, in the units of the file
  std::optional<std::string> to;     ///< likewise
  std::optional<std::string> steps;  ///< likewise
  std::optional<std::string> label;  ///< of the case
  std::vector<std::string> report;   ///< replaces the list of the file, unless it is empty
};

/// A motion that was found, as far as it goes.
struct FoundMotion {
  MotionPlan plan;
  MotionNetwork network;
  std::vector<DrawnCoupling> drawn;
  MotionSolution solution;
  MotionTable table;
  std::optional<Mechanism> near;  ///< of a mechanism far from the origin of the world: beside it,
                                  ///< as it was moved; network, couplings and plan are of this one
  Vec3 origin = Vec3::Zero();     ///< where its origin is in the world [m]
};

/// Runs the section `motion` of a description that has been bound to this mechanism. What became of
/// it is added to `found`; empty iff there is nothing to report, with an error.
std::optional<FoundMotion> find_motion(const MechanismDescription& description,
                                       const Mechanism& mechanism,
                                       Diagnostics& found);

/// One report a file, on standard output or as files. A file without a section `motion` is an
/// error unless the choice names a drive.
Outcome motion_of_files(const std::vector<std::string>& paths,
                        const MotionChoice& choice,
                        const AnalyseOptions& options);

}  // namespace kinestat
