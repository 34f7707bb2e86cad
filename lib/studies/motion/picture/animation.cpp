#include "studies/motion/picture/animation.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "draw/axes.hpp"
#include "draw/picture_title.hpp"
#include "studies/motion/motion.hpp"
#include "studies/motion/picture/drawn_motion_maker.hpp"

namespace kinestat {

namespace {

constexpr double kSeconds = 4.0;  // of a cycle

// Of a cycle: more look no smoother or, of what is drawn anew for each, make the picture too long.
constexpr std::size_t kMostIntervals = 120;
constexpr std::size_t kMostDrawings = 60;

constexpr std::size_t kMostPathPoints = 1000;

// A motion of many steps that ends early is shown as it is.
constexpr std::size_t kMostSteps = 100'000;

// Between positions from the first to the last.
std::size_t most_intervals(const Mechanism& mechanism, bool goes_round) {
  const std::size_t most = mechanism.space == Space::planar ? kMostIntervals : kMostDrawings;
  const std::size_t of_way = goes_round ? most : most / 2;
  return moves_by_matrices(mechanism) ? of_way : std::min(of_way, most_frames(mechanism));
}

bool goes_round(const FoundMotion& found, const Mechanism& mechanism) {
  const std::vector<std::size_t> ends = {0, found.solution.shares.size() - 1};
  return is_closed(mechanism, make_drawn_motion(found, found.solution, ends, mechanism));
}

// With each step divided, where that ends as it did.
MotionSolution divided(const FoundMotion& found, std::size_t parts) {
  const std::size_t steps = static_cast<std::size_t>(found.plan.steps) * parts;
  if (parts < 2 || steps > kMostSteps || found.plan.schedule) {  // whose steps are those of time
    return found.solution;
  }
  MotionSolution finer = solve_motion(
      found.network, {.drives = found.solution.drives, .steps = static_cast<int>(steps)});
  const std::size_t before_last = found.solution.shares.size() - 2;
  const bool ends_alike =
      finer.status == found.solution.status && finer.shares.size() > before_last * parts;
  return ends_alike ? finer : found.solution;
}

void thin_out(TracedPath& path) {
  std::vector<Vec3> kept;
  for (const std::size_t i : spread_positions(path.points.size(), kMostPathPoints)) {
    kept.push_back(path.points[i]);
  }
  path.points = std::move(kept);
}

DrawnMotion smooth_motion(const FoundMotion& found, const Mechanism& mechanism) {
  const std::size_t count = found.solution.shares.size();
  if (count < 2) {
    return make_drawn_motion(found, found.solution, spread_positions(count, 1), mechanism);
  }
  const std::size_t most = most_intervals(mechanism, goes_round(found, mechanism));
  const MotionSolution solution = divided(found, most / (count - 1));
  const std::vector<std::size_t> shown = spread_positions(solution.shares.size(), most + 1);
  DrawnMotion motion = make_drawn_motion(found, solution, shown, mechanism);
  std::ranges::for_each(motion.paths, thin_out);
  return motion;
}

// "motor from 0 to 360 deg".
std::string travel_words(const MotionTable& table) {
  std::vector<std::string> words;
  for (const DriveTravel& drive : table.drives) {
    words.push_back(fmt::format("{} from {} to {} {}",
                                drive.name,
                                label_number(drive.from),
                                label_number(drive.reached.value_or(drive.to)),
                                drive.unit));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

MovingMechanism moving_mechanism(std::string file,
                                 const MechanismDescription& description,
                                 const Mechanism& mechanism,
                                 const FoundMotion& found) {
  return {.still = {.file = std::move(file),
                    .description = description,
                    .mechanism = mechanism,
                    .mobility = {},
                    .cases = {},
                    .shift = {},
                    .affine = {}},
          .motion = smooth_motion(found, mechanism)};
}

Picture draw_animation(const MovingMechanism& moving, const MotionTable& table) {
  const Mechanism& mechanism = moving.still.mechanism;
  const bool is_round = is_closed(mechanism, moving.motion);
  LinkageOptions options = motion_options(mechanism, moving.motion);
  options.shows_names = false;
  options.cycle = motion_cycle(mechanism, moving.motion, kSeconds);
  if (!options.frames.empty()) {
    options.cycle->pace.is_stepwise = true;  // as the frames are
    if (is_round) {
      options.frames.pop_back();  // the first again
    }
  }
  Picture picture = draw_linkage(moving.still, options);
  picture.name = "animation";
  picture.title = picture_title("Mechanism in motion", moving.still);
  picture.description += fmt::format(" It goes through its motion, {}: {}.",
                                     is_round ? "again and again" : "there and back",
                                     travel_words(table));
  return picture;
}

}  // namespace kinestat
