// How long a friction rests that turns round.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "studies/motion/task/friction_sliding.hpp"

namespace kinestat {

/// Where a friction turns round, in steps: at one place, or with a rest of its drive between.
struct FrictionRest {
  double begin = 0.0;
  double end = 0.0;
};

/// Seeks each once, for the places beside it and for its event.
class FrictionRests {
 public:
  /// `places` as of the motion that is looked at; `position_at` answers with speeds at a step, and
  /// empty where the motion cannot be followed to there. All must outlive it.
  FrictionRests(const Mechanism& mechanism,
                const FoundMotion& motion,
                std::span<const FrictionPlace> places,
                std::function<std::optional<MotionPosition>(double step)> position_at)
      : mechanism_(mechanism),
        motion_(motion),
        places_(places),
        position_at_(std::move(position_at)) {}

  /// Of a friction that slides one way before and the other behind. How long it rests: while a
  /// drive dwells; else it only turns round, where a drive does, between two places or at the one
  /// between them. Empty where it is unknown.
  std::optional<FrictionRest> between(std::size_t friction, const PlacesAround& about);

  /// The same of a turn that may be at an end of the motion.
  std::optional<FrictionRest> of(const FrictionTurn& turn, const PlacesAround& about);

 private:
  std::optional<FrictionRest> find(std::size_t friction, const PlacesAround& about);
  std::optional<Vec3> sliding_at(std::size_t friction, double step) const;
  double find_turn(std::size_t friction, const Vec3& first, const PlacesAround& about) const;

  const Mechanism& mechanism_;
  const FoundMotion& motion_;
  std::span<const FrictionPlace> places_;
  std::function<std::optional<MotionPosition>(double step)> position_at_;
  std::map<std::pair<std::size_t, double>, std::optional<FrictionRest>>
      known_;  // by friction and place before
};

}  // namespace kinestat
