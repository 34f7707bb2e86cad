// A finite motion as drawings of the mechanism show it.
#pragma once

#include <cstddef>
#include <vector>

#include "draw/linkage/linkage_drawing.hpp"

namespace kinestat {

struct DrawnMotion {
  std::vector<LinkagePosition> positions;
  std::vector<double> shares;     ///< of the ranges of the drives, of each position; rising
  std::vector<TracedPath> paths;  ///< over all positions of the motion
};

/// Of that many positions some at equal distances, the first and the last among them; hardly more
/// than `most`.
std::vector<std::size_t> spread_positions(std::size_t count, std::size_t most);

/// Whether a matrix moves all that a drawing shows of the mechanism. Else it is drawn anew for
/// every position.
bool moves_by_matrices(const Mechanism& mechanism);

/// More positions would make a drawing too long that is drawn anew for each.
std::size_t most_frames(const Mechanism& mechanism);

/// Where couplings and reference points are with these poses: adds them to what the picture must
/// hold.
void add_places(const Mechanism& mechanism,
                const std::vector<BodyPose>& poses,
                LinkageOptions& options);

/// The drawing that holds all positions, with the paths and with what is drawn anew for each.
LinkageOptions motion_options(const Mechanism& mechanism, const DrawnMotion& motion);

/// Whether no body is seen to have moved from some poses to others.
bool are_same(const Mechanism& mechanism,
              const std::vector<BodyPose>& some,
              const std::vector<BodyPose>& others);

/// Whether the motion comes back to where it began, so that it can go round. There must be a
/// position.
bool is_closed(const Mechanism& mechanism, const DrawnMotion& motion);

/// Round and round or, where it is not closed, there and back; as fast as the drives go evenly. The
/// motion must have two positions.
LinkageCycle motion_cycle(const Mechanism& mechanism, const DrawnMotion& motion, double seconds);

}  // namespace kinestat
