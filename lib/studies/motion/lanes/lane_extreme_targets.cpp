#include "studies/motion/lanes/lane_extreme_targets.hpp"

namespace kinestat {

LaneExtremeTargets::LaneExtremeTargets(const LaneQuestion& question) {
  const std::size_t places = question.places.size();
  values.resize(places);
  for (std::size_t p = 0; p < question.sides.size(); ++p) {
    add(p, question.sides[p]);
  }
  if (question.transmission) {
    add(places, question.transmission_sides);
  }
  const std::size_t positions = static_cast<std::size_t>(question.steps) + 1;
  for (const LaneTarget& one : targets) {
    if (one.place < places) {
      values[one.place].resize(positions);
    } else {
      angles.resize(positions);
    }
  }
}

void LaneExtremeTargets::add(std::size_t place, const LaneSides& sides) {
  if (sides.least) {
    targets.push_back({.place = place, .sign = -1.0});
  }
  if (sides.greatest) {
    targets.push_back({.place = place, .sign = 1.0});
  }
}

}  // namespace kinestat
