// A sweep made ready: what all its workers share and none of them changes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/load_file.hpp"
#include "studies/sweep/motion/swept_motion.hpp"
#include "studies/sweep/report/sweep_column.hpp"
#include "studies/sweep/sweep_plan.hpp"
#include "studies/sweep/task/row_choice.hpp"
#include "studies/sweep/task/sweep_options.hpp"
#include "studies/sweep/task/sweep_tapes.hpp"
#include "studies/sweep/task/swept_gears.hpp"

namespace kinestat {

struct SweepTask {
  MechanismDescription description;  ///< without the sections that a state does not need
  Mechanism mechanism;               ///< with the parameters of the file
  SweepPlan plan;
  std::vector<std::size_t> chosen;  ///< which of all cases are run
  std::vector<Case> cases;          ///< these, with the parameters of the file
  std::optional<ShiftPlan> shift;   ///< of the file's section, with its parameters
  double forward = 1.0;  ///< the sign of the ratios of forward gears, as in its shift table
  std::vector<std::optional<SweptGear>> gears;  ///< of each of `cases`: its combination, if any
  std::vector<bool> is_usually_solved;  ///< of each: whether it has an answer as the file has it
  std::vector<SweepColumn> columns;
  std::optional<SweptMotion> motion;  ///< what columns need of it; empty where none is of a motion
  bool has_motion_alone = false;      ///< then no state is solved in one position
  bool has_statics = false;           ///< whether a quantity needs actions
  RowChoice choice;                   ///< which rows are written
  std::optional<SweepTapes> tapes;  ///< which refer to the task, so that it must stay in its place;
                                    ///< empty where every state is analysed as a whole
  SweepMetadata metadata;
};

/// The cases of a sweep with no more passes than its quantities need; one without a name where a
/// motion has none.
std::vector<Case> chosen_cases(const SweepTask& task, const Mechanism& mechanism);

/// Without tapes. Empty iff an error was added.
std::optional<SweepTask> make_sweep_task(const SourceFile& source,
                                         Loaded loaded,
                                         const SweepOptions& options,
                                         Diagnostics& found);

}  // namespace kinestat
