// The frictions of a motion, at its rows and between them.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "cases/findings/case_findings.hpp"
#include "studies/motion/followed_configurations.hpp"
#include "studies/motion/report/motion_table.hpp"
#include "studies/motion/task/friction_sliding.hpp"
#include "studies/motion/task/position_findings.hpp"

namespace kinestat {

/// Sees where they turn round and rest, wherever the rows stand, and what is found there.
class FrictionWatch {
 public:
  FrictionWatch(const MechanismDescription& description,
                const Mechanism& mechanism,
                const FoundMotion& motion);

  /// In order.
  void add_row(double step, FrictionSliding sliding);

  /// Once all rows are added, of which this is said; `positions` answers as for these.
  void look_between(std::span<const CaseFindings> said, MotionPositions& positions);

  /// Likewise: the turns are those of the table, too, and rows of it get their status.
  void find_turns(MotionPositions& positions, MotionTable& table);

  /// What is found at the rows, of which this is said, and between them.
  void tell(std::span<const CaseFindings> said,
            const MotionTable& table,
            PositionFindings& found) const;

  /// The rows, and places between them where frictions slide otherwise.
  std::span<const FrictionPlace> places() const { return places_; }

  std::span<const FrictionTurn> turns() const { return turns_; }  ///< in steps

 private:
  // Of a place between the rows.
  struct Between {
    CaseFindings said;
    std::string status;
  };

  std::optional<MotionPosition> position_at(double step, MotionPositions& positions);

  const MechanismDescription& description_;
  const Mechanism& mechanism_;
  const FoundMotion& motion_;
  FollowedConfigurations configurations_;
  std::vector<FrictionPlace> places_;
  std::vector<FrictionTurn> turns_;
  std::map<double, Between> between_;  // by their steps
};

}  // namespace kinestat
