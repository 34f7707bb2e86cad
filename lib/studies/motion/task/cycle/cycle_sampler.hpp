// The values of a motion in time wherever they are asked for.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "math/dense/legendre_pieces.hpp"
#include "studies/motion/followed_configurations.hpp"
#include "studies/motion/task/found_motion.hpp"
#include "studies/motion/task/motion_position.hpp"

namespace kinestat {

/// How fast a steady motion runs there, as multiple of the speed of its case.
enum class CyclePace { half, whole, twice };

/// A value, and how large what it is made of is.
struct CycleValue {
  double value = 0.0;
  double size = 0.0;
};

/// One or several of them at a position, always as many; empty where one has none.
using CycleReading = std::function<std::optional<std::vector<CycleValue>>(const MotionPosition&)>;

/// A motion in time that came to its end, with all passes of its case.
class CycleSampler {
 public:
  CycleSampler(const Mechanism& mechanism, const FoundMotion& motion);
  ~CycleSampler();
  CycleSampler(const CycleSampler&) = delete;
  CycleSampler& operator=(const CycleSampler&) = delete;

  /// At a share of the time. At another pace it is where it is at that share of the time of that,
  /// if its only drive runs steadily.
  std::optional<MotionPosition> at(double time, CyclePace pace = CyclePace::whole);

  /// What is read along the motion, over the share of the time.
  std::optional<LegendrePieces> find(const CycleReading& reading);

  /// Likewise at several paces, one after the other.
  std::optional<LegendrePieces> find(const CycleReading& reading, std::span<const CyclePace> paces);

  const Mechanism& mechanism() const { return mechanism_; }

  const FoundMotion& motion() const { return motion_; }

  /// Where the first drive is at a share of the time [rad or m].
  double drive_at(double time) const;

  /// What the drives of a steady motion have as speed [rad/s or m/s].
  double drive_speed() const;

 private:
  struct Run;

  Run& run_of(CyclePace pace);

  const Mechanism& mechanism_;
  const FoundMotion& motion_;
  FollowedConfigurations configurations_;
  std::array<std::unique_ptr<Run>, 3> runs_;
};

}  // namespace kinestat
