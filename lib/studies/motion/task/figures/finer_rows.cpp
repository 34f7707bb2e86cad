#include "studies/motion/task/figures/finer_rows.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>
#include <utility>

#include "core/motion_tolerance.hpp"
#include "studies/motion/followed_configurations.hpp"

namespace kinestat {

namespace {

// Of a motion, and of each turn of a drive.
constexpr double kLeastSteps = 24.0;
constexpr double kMostSteps = 720.0;

class StepDivider {
 public:
  StepDivider(const Mechanism& mechanism, const FoundMotion& motion, int parts)
      : motion_(motion),
        parts_(parts),
        configurations_(mechanism, motion.network, motion.solution) {}

  std::optional<FinerMotion> run() {
    const MotionSolution& coarse = motion_.solution;
    begin(coarse);
    const int last = coarse.position_count() - 1;
    for (int row = 0; row < last; ++row) {
      add(coarse.shares[at(row)], coarse.configuration_at(row), row);
      finer_.rows.push_back(finer_.motion.solution.shares.size() - 1);
      for (int part = 1; part < parts_; ++part) {
        const double share = share_of(row, part);
        if (share >= coarse.shares[at(row + 1)]) {
          break;
        }
        const std::optional<Configuration> there = configurations_.at(share);
        if (!there) {
          return std::nullopt;
        }
        add(share, *there, row);
      }
    }
    add(coarse.shares.back(), coarse.configuration_at(last), last);
    finer_.rows.push_back(finer_.motion.solution.shares.size() - 1);
    place_special();
    return std::move(finer_);
  }

 private:
  static std::size_t at(int row) { return static_cast<std::size_t>(row); }

  void begin(const MotionSolution& coarse) {
    FoundMotion& fine = finer_.motion;
    fine.plan = motion_.plan;
    fine.plan.steps *= parts_;
    fine.network = motion_.network;
    fine.drawn = motion_.drawn;
    fine.solution = coarse;
    fine.solution.shares.clear();
    fine.solution.closure_errors.clear();
    fine.solution.coordinates.clear();
    fine.solution.angles.clear();
  }

  // A motion that ends early divides its last step in time like the others, else as it is.
  double share_of(int row, int part) const {
    const int steps = motion_.plan.steps;
    const auto equal = [&](double count) { return count / (static_cast<double>(parts_) * steps); };
    const double count = static_cast<double>(row) * parts_ + part;
    const std::vector<double>& shares = motion_.solution.shares;
    if (motion_.plan.schedule) {
      return motion_.plan.schedule->share_at(equal(count));
    }
    const bool is_whole_step = shares[at(row)] == static_cast<double>(row) / steps &&
                               shares[at(row + 1)] == static_cast<double>(row + 1) / steps;
    return is_whole_step ? equal(count)
                         : std::lerp(shares[at(row)],
                                     shares[at(row + 1)],
                                     static_cast<double>(part) / static_cast<double>(parts_));
  }

  // With what the row before misses of closure.
  void add(double share, const Configuration& there, int row) {
    MotionSolution& fine = finer_.motion.solution;
    fine.shares.push_back(share);
    fine.closure_errors.push_back(motion_.solution.closure_errors[at(row)]);
    fine.coordinates.insert(
        fine.coordinates.end(), there.coordinates.begin(), there.coordinates.end());
    fine.angles.insert(fine.angles.end(), there.angles.begin(), there.angles.end());
  }

  void place_special() {
    MotionSolution& fine = finer_.motion.solution;
    for (SpecialPosition& one : fine.special) {
      if (one.step < 0) {
        continue;
      }
      std::size_t before = finer_.rows[at(one.step)];
      while (before + 2 < fine.shares.size() && fine.shares[before + 1] < one.share) {
        ++before;
      }
      one.step = static_cast<int>(before);
    }
  }

  const FoundMotion& motion_;
  int parts_;
  FollowedConfigurations configurations_;
  FinerMotion finer_;
};

// A finer row lies between two rows that are kept, or is one of them.
class KeptRows {
 public:
  explicit KeptRows(std::span<const std::size_t> rows) : rows_(rows) {}

  bool has(std::size_t row) const { return std::ranges::binary_search(rows_, row); }

  std::size_t before(std::size_t row) const {
    return static_cast<std::size_t>(std::prev(std::ranges::upper_bound(rows_, row)) -
                                    rows_.begin());
  }

  std::size_t behind(std::size_t row) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(rows_, row) - rows_.begin());
  }

  double place_of(double row) const {
    if (row < 0.0) {
      return row;
    }
    const std::size_t low = before(static_cast<std::size_t>(row));
    if (low + 1 == rows_.size()) {
      return static_cast<double>(low);
    }
    const auto from = static_cast<double>(rows_[low]);
    const auto to = static_cast<double>(rows_[low + 1]);
    return static_cast<double>(low) + (row - from) / (to - from);
  }

 private:
  std::span<const std::size_t> rows_;
};

// There and back counts twice.
double way_of(const MotionPlan& plan, std::size_t drive) {
  if (!plan.schedule) {
    return std::abs(plan.drives[drive].to - plan.drives[drive].from);
  }
  std::vector<double> times = plan.schedule->turns();
  times.push_back(1.0);
  double way = 0.0;
  double before = plan.schedule->at(drive, 0.0).position;
  for (const double time : times) {
    const double now = plan.schedule->at(drive, time).position;
    way += std::abs(now - before);
    before = now;
  }
  return way;
}

}  // namespace

int parts_of_step(const Mechanism& mechanism, const MotionPlan& plan, int steps) {
  double wanted = kLeastSteps;
  for (std::size_t d = 0; d < plan.drives.size(); ++d) {
    const auto freedom = static_cast<std::size_t>(plan.drives[d].freedom);
    if (mechanism.topology.freedoms[freedom].is_rotation) {
      const double turns = way_of(plan, d) / (2.0 * std::numbers::pi);
      wanted = std::max(wanted, std::min(kLeastSteps * turns, kMostSteps));
    }
  }
  return steps > 0 ? std::max(1, static_cast<int>(std::ceil(wanted / steps - kSameStep))) : 1;
}

std::optional<FinerMotion> divide_steps(const Mechanism& mechanism, const FoundMotion& motion) {
  const int parts = parts_of_step(mechanism, motion.plan, motion.solution.position_count() - 1);
  return parts > 1 ? StepDivider(mechanism, motion, parts).run() : std::nullopt;
}

void keep_rows(const FinerMotion& finer, int steps, MotionTable& table) {
  const KeptRows kept(finer.rows);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const std::string& status = table.rows[row].status;
    if (!kept.has(row) && status != "solved" &&
        std::ranges::find(table.between, status) == table.between.end()) {
      table.between.push_back(status);
    }
  }
  std::vector<MotionRow> rows;
  for (const std::size_t row : finer.rows) {
    rows.push_back(std::move(table.rows[row]));
    rows.back().step = static_cast<int>(rows.size()) - 1;
  }
  table.rows = std::move(rows);
  for (MotionEvent& event : table.events) {
    event.step = event.step < 0
                     ? event.step
                     : static_cast<int>(kept.before(static_cast<std::size_t>(event.step)));
    event.row = kept.place_of(event.row);
  }
  for (ColumnFigures& figures : table.figures) {
    for (std::optional<ColumnExtreme>* one : {&figures.least, &figures.greatest}) {
      if (*one) {
        (*one)->row = kept.place_of((*one)->row);
      }
    }
    for (std::size_t& pole : figures.poles) {
      pole = kept.behind(pole);
    }
    figures.poles.erase(std::unique(figures.poles.begin(), figures.poles.end()),
                        figures.poles.end());
  }
  for (MotionPlace& place : table.places) {
    place.row = kept.place_of(place.row);
  }
  for (double& corner : table.corners) {
    corner *= static_cast<double>(steps) / finer.motion.plan.steps;
  }
  for (FrictionTurn& turn : table.friction_turns) {
    for (PlacesAround& one : turn.turns) {
      one = {.before = kept.place_of(one.before), .after = kept.place_of(one.after)};
    }
  }
  table.worst_step = static_cast<int>(kept.before(static_cast<std::size_t>(table.worst_step)));
  table.steps = steps;
}

}  // namespace kinestat
