#include "studies/motion/task/reversals.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>

#include "core/index.hpp"
#include "core/motion_tolerance.hpp"
#include "studies/motion/configuration.hpp"

namespace kinestat {

namespace {

class MotionEnds {
 public:
  MotionEnds(const Mechanism& mechanism, const FoundMotion& motion)
      : mechanism_(mechanism),
        motion_(motion),
        begin_(positions_at(0)),
        end_(positions_at(motion.solution.position_count() - 1)) {}

  bool is_begin(const DeadPoint& point) const {
    return is_one_place(motion_.solution.shares.front(), point.share, point.uncertainty);
  }

  bool is_end(const DeadPoint& point) const {
    return is_one_place(point.share, motion_.solution.shares.back(), point.uncertainty);
  }

  // A drive that turns back or rests at a dead point ends one part of its way there and begins the
  // next.
  bool are_one(const DeadPoint& before, const DeadPoint& after) const {
    return before.freedom == after.freedom &&
           is_one_place(before.share, after.share, before.uncertainty + after.uncertainty);
  }

  // Whether the drives and the freedom are at the end where they were at the begin.
  bool meet(int freedom) const {
    return is_same(freedom) && std::ranges::all_of(motion_.network.driven_freedoms,
                                                   [&](int drive) { return is_same(drive); });
  }

 private:
  using Positions = std::vector<std::optional<double>>;

  Positions positions_at(int position) const {
    return freedom_positions(
        motion_.network, mechanism_, motion_.solution.configuration_at(position));
  }

  // Whether two shares are the same, or no drive moves between them: from turn to turn it runs one
  // way or rests.
  bool is_one_place(double from, double to, double uncertainty) const {
    const MotionSolution& solution = motion_.solution;
    if (std::abs(to - from) <= std::max(2.0 * uncertainty, kDeadPointBracket)) {
      return true;
    }
    std::vector<double> shares = {to};
    std::ranges::copy_if(solution.turns, std::back_inserter(shares), [&](double turn) {
      return turn > from && turn < to;
    });
    return solution.path && std::ranges::all_of(shares, [&](double share) {
             return is_same_place_of_drives(from, share);
           });
  }

  bool is_same_place_of_drives(double from, double to) const {
    const MotionSolution& solution = motion_.solution;
    for (std::size_t d = 0; d < solution.drives.size(); ++d) {
      const bool turns = mechanism_.topology.freedoms[at(solution.drives[d].freedom)].is_rotation;
      const double unit = turns ? 1.0 : motion_.network.length;
      if (std::abs(solution.path(d, to) - solution.path(d, from)) > kSilentCorrection * unit) {
        return false;
      }
    }
    return true;
  }

  // Up to whole turns.
  bool is_same(int freedom) const {
    const std::optional<double>& begin = begin_[at(freedom)];
    const std::optional<double>& end = end_[at(freedom)];
    if (!begin || !end) {
      return false;
    }
    const bool turns = mechanism_.topology.freedoms[at(freedom)].is_rotation;
    const double way = turns ? std::remainder(*end - *begin, 2.0 * std::numbers::pi)
                             : (*end - *begin) / motion_.network.length;
    return std::abs(way) <= kSilentCorrection;
  }

  const Mechanism& mechanism_;
  const FoundMotion& motion_;
  Positions begin_;
  Positions end_;
};

}  // namespace

void judge_reversals(const Mechanism& mechanism,
                     const FoundMotion& motion,
                     std::vector<DeadPoint>& points) {
  if (points.empty()) {
    return;
  }
  const MotionEnds ends(mechanism, motion);
  for (std::size_t p = 0; p < points.size(); ++p) {
    DeadPoint& point = points[p];
    const auto begins = [&](const DeadPoint& other) {
      return other.freedom == point.freedom && ends.is_begin(other);
    };
    if (ends.is_begin(point)) {
      point.reverses = ends.meet(point.freedom);
    } else if (ends.is_end(point)) {
      point.reverses = ends.meet(point.freedom) && std::ranges::none_of(points, begins);
    } else {
      point.reverses = std::none_of(points.begin(),
                                    points.begin() + static_cast<std::ptrdiff_t>(p),
                                    [&](const DeadPoint& one) { return ends.are_one(one, point); });
    }
  }
}

}  // namespace kinestat
