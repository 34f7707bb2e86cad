#include "studies/motion/task/cycle/cycle_sampler.hpp"

#include <algorithm>
#include <utility>

#include "core/motion_tolerance.hpp"

namespace kinestat {

namespace {

constexpr std::size_t kLeastPieces = 8;
constexpr std::size_t kMostFirstPieces = 500;
constexpr std::size_t kStepsAPiece = 8;
constexpr std::size_t kMostPieces = 5'000;

double factor_of(CyclePace pace) {
  switch (pace) {
    case CyclePace::half:
      return 0.5;
    case CyclePace::whole:
      return 1.0;
    case CyclePace::twice:
      return 2.0;
  }
  return 1.0;
}

MotionPlan paced(const MotionPlan& plan, double factor) {
  MotionPlan result = plan;
  if (factor != 1.0) {
    const DriveInstant start = plan.schedule->at(0, 0.0);
    const PlannedDrive& drive = plan.drives.front();
    result.schedule.emplace(plan.schedule->duration() / factor,
                            std::vector<DriveCourse>{{.from = drive.from,
                                                      .to = drive.to,
                                                      .speed = factor * start.speed,
                                                      .acceleration = 0.0}});
  }
  return result;
}

}  // namespace

// What the positions of one pace need.
struct CycleSampler::Run {
  Run(const Mechanism& mechanism, const FoundMotion& motion, double factor)
      : plan(paced(motion.plan, factor)),
        positions(mechanism,
                  plan,
                  motion.network,
                  motion.drawn,
                  {.velocity = true,
                   .acceleration = true,
                   .statics = true,
                   .reduced_equation = true,
                   .closure_error = worst_closure_error(motion.solution)}) {}

  MotionPlan plan;
  MotionPositions positions;
};

CycleSampler::CycleSampler(const Mechanism& mechanism, const FoundMotion& motion)
    : mechanism_(mechanism),
      motion_(motion),
      configurations_(mechanism, motion.network, motion.solution) {}

CycleSampler::~CycleSampler() = default;

CycleSampler::Run& CycleSampler::run_of(CyclePace pace) {
  std::unique_ptr<Run>& run = runs_[static_cast<std::size_t>(pace)];
  if (!run) {
    run = std::make_unique<Run>(mechanism_, motion_, factor_of(pace));
  }
  return *run;
}

std::optional<MotionPosition> CycleSampler::at(double time, CyclePace pace) {
  const double share = motion_.plan.schedule->share_at(time);
  const std::optional<Configuration> there = configurations_.at(share);
  if (!there) {
    return std::nullopt;
  }
  return run_of(pace).positions.at(*there, share, time);
}

std::optional<LegendrePieces> CycleSampler::find(const CycleReading& reading) {
  constexpr std::array kPaces = {CyclePace::whole};
  return find(reading, kPaces);
}

std::optional<LegendrePieces> CycleSampler::find(const CycleReading& reading,
                                                 std::span<const CyclePace> paces) {
  const FunctionsAt functions = [&](double time) -> std::optional<FunctionValues> {
    std::vector<CycleValue> values;
    for (const CyclePace pace : paces) {
      const std::optional<MotionPosition> position = at(time, pace);
      const auto read = position ? reading(*position) : std::nullopt;
      if (!read) {
        return std::nullopt;
      }
      values.insert(values.end(), read->begin(), read->end());
    }
    const auto count = static_cast<Eigen::Index>(values.size());
    FunctionValues result{.values = VecX(count), .sizes = VecX(count)};
    for (Eigen::Index f = 0; f < count; ++f) {
      result.values[f] = values[static_cast<std::size_t>(f)].value;
      result.sizes[f] = values[static_cast<std::size_t>(f)].size;
    }
    return result;
  };
  const auto steps = static_cast<std::size_t>(motion_.plan.steps);
  const std::size_t count = std::clamp(steps / kStepsAPiece, kLeastPieces, kMostFirstPieces);
  std::vector<double> places;
  for (std::size_t i = 0; i <= count; ++i) {
    places.push_back(static_cast<double>(i) / static_cast<double>(count));
  }
  // At corners and jumps pieces begin and end.
  for (const double corner : motion_.table.corners) {
    places.push_back(std::clamp(corner / static_cast<double>(steps), 0.0, 1.0));
  }
  std::ranges::sort(places);
  const auto is_same = [](double a, double b) { return b - a < kFinestCyclePiece; };
  places.erase(std::unique(places.begin(), places.end(), is_same), places.end());
  places.back() = 1.0;
  return LegendrePieces::find(
      functions,
      places,
      {.tail = kCycleTail, .noise = kCycleNoise, .finest = kFinestCyclePiece, .most = kMostPieces});
}

double CycleSampler::drive_at(double time) const {
  return motion_.plan.schedule->at(0, time).position;
}

double CycleSampler::drive_speed() const {
  return motion_.plan.schedule->at(0, 0.0).speed;
}

}  // namespace kinestat
