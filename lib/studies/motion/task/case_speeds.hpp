// The speeds of the drives of a motion that a case gives, whatever it knows.
#pragma once

#include <vector>

#include "mechanism/motion_plan.hpp"
#include "studies/motion/motion_state.hpp"

namespace kinestat {

/// What the known motions of a case say of the drives at a position.
enum class SpeedsKnown {
  all,
  dependent,    ///< they know more than the freedoms allow, be it the same twice
  too_few,      ///< they leave a drive open
  not_by_state  ///< nothing can be said: the position is singular
};

struct CaseSpeeds {
  SpeedsKnown known = SpeedsKnown::all;
  GivenSpeeds speeds;  ///< then: with bounds where they were solved for
};

/// Solves for them: with G the rates of what the case knows for each drive alone, G s = known, and
/// G ds/dt = -h, h being how the known rates would change with steady drives.
class CaseSpeedSolver {
 public:
  CaseSpeedSolver(const MotionNetwork& network,
                  std::span<const DrawnCoupling> drawn,
                  const Mechanism& mechanism,
                  const MotionPlan& plan,
                  const Case& which,
                  MotionStates& states)
      : network_(network),
        drawn_(drawn),
        mechanism_(mechanism),
        plan_(plan),
        which_(which),
        states_(states) {}

  CaseSpeeds find(const Configuration& configuration, StateDetail detail) const;

 private:
  struct Response;

  const Primary* known_of(const PlannedDrive& drive) const;
  double unit_of(int freedom) const;
  bool is_open(int freedom, const Configuration& configuration) const;
  CaseSpeeds solve(const std::vector<const Primary*>& known,
                   const GivenSpeeds& rest,
                   const Configuration& configuration,
                   StateDetail detail) const;
  bool find_response(const std::vector<const Primary*>& known,
                     const GivenSpeeds& rest,
                     const Configuration& configuration,
                     StateDetail detail,
                     Response& response) const;

  const MotionNetwork& network_;
  std::span<const DrawnCoupling> drawn_;
  const Mechanism& mechanism_;
  const MotionPlan& plan_;
  const Case& which_;
  MotionStates& states_;
};

}  // namespace kinestat
