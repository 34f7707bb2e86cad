// What there is to say of the positions of a motion, each thing once.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cases/findings/case_findings.hpp"
#include "core/diagnostic.hpp"
#include "studies/motion/configuration.hpp"
#include "studies/motion/report/motion_table.hpp"
#include "studies/motion/task/found_motion.hpp"
#include "studies/motion/task/motion_position.hpp"

namespace kinestat {

/// A position of which there is something to say.
struct FoundPlace {
  std::optional<std::size_t> row;  ///< counted from 0; empty between two rows
  double drive = 0.0;              ///< position of the first drive, in its unit
  std::optional<double> time;      ///< in a motion in time, in its unit
};

/// Gathers the findings of the positions of a motion, in their order.
class PositionFindings {
 public:
  /// Of the rows that are added the table keeps only these; what holds in others alone is told as
  /// between the steps.
  void keep(std::vector<std::size_t> rows) { kept_ = std::move(rows); }

  void add(const FoundPlace& place, const CaseFindings& found);

  bool has_errors() const;

  /// Tells each with the brackets of the first drive in which it holds. Of one that `found` says of
  /// the drawn position already and that holds everywhere, nothing more is said.
  void tell(const MotionTable& table, Diagnostics& found) const;

 private:
  // A position that was added.
  struct Place {
    std::size_t count = 0;  // of those before
    double drive = 0.0;
    std::optional<double> time;
    bool is_kept = true;
  };

  // One finding, as it is where it is worst.
  struct Held {
    CaseFinding worst;
    Place worst_at;
    bool varies = false;  ///< it is not the same everywhere
    std::vector<Place> places;
  };

  static std::string text_of(const Place& place, const MotionTable& table);
  static std::string brackets_text(std::span<const Place> places, const MotionTable& table);

  std::vector<Held> held_;
  std::size_t count_ = 0;          // of the positions that were added
  std::vector<std::size_t> kept_;  // empty: all
};

/// Cables that cross themselves in this configuration with these poses, unless the file says that
/// they are meant to.
void add_crossing_cables(const MechanismDescription& description,
                         const Mechanism& mechanism,
                         const FoundMotion& motion,
                         const Configuration& configuration,
                         std::span<const BodyPose> poses,
                         CaseFindings& found);

/// What there is to say of the case at a position, as that of a row; nothing where it has no
/// answer. What was said of the position before is not worded again.
CaseFindings judge_position(const MechanismDescription& description,
                            const MotionPlan& plan,
                            const MotionPosition& position,
                            const Mechanism& moved,
                            const CaseFindings* before);

/// "solved", "singular" or that of its case.
std::string status_of_position(const MotionPlan& plan,
                               const MotionPosition& position,
                               const Mechanism& moved);

/// W0516, why a case has no efficiency; nothing where it locks itself, which others tell.
void add_efficiency_findings(const Mechanism& mechanism,
                             const CaseAnalysis& one,
                             CaseFindings& found);

/// "m = 5 deg, n = 20 mm": the positions of the drives; or the time, where these do not say when.
std::string row_place(const MotionTable& table, const MotionRow& row);
std::string event_place(const MotionTable& table, const MotionEvent& event);

}  // namespace kinestat
