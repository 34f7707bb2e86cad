// Times rows of motions with actions: with inertia, in units of those with weights alone, and
// beside Simbody where that is installed.

#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench_program.hpp"
#include "files/load_file.hpp"
#include "interleave.hpp"
#include "mass_linkage.hpp"
#include "mechanism/bind/bind.hpp"
#include "ratio_table.hpp"
#include "studies/motion/motion.hpp"
#include "studies/motion/task/columns/column_detail.hpp"
#include "studies/motion/task/columns/motion_columns.hpp"
#include "studies/motion/task/find_motion.hpp"
#ifdef KINESTAT_HAS_SIMBODY
#include "simbody_rows.hpp"
#endif

namespace kinestat::bench {

namespace {

constexpr double kWithInertia = 1.1;    // rows with weights alone
constexpr double kBesideSimbody = 0.2;  // rows with inertia as against those of Simbody
constexpr double kSameAction = 1e-7;

constexpr int kSteps = 360;

// From the positions to the actions of all couplings in each.
class Rows {
 public:
  Rows(const MassLinkage& linkage, bool has_inertia) {
    const SourceFile source{.path = linkage.name, .text = file_text(linkage, has_inertia, kSteps)};
    Diagnostics found;
    std::optional<MechanismDescription> description = read_description(source, {}, found);
    std::optional<Mechanism> mechanism =
        description ? kinestat::bind(*description, found) : std::nullopt;
    std::optional<FoundMotion> motion;
    if (mechanism) {
      mechanism_ = *std::move(mechanism);
      motion =
          follow_motion(*description, mechanism_, *bind_motion(*description, mechanism_), found);
    }
    if (!motion || motion->solution.position_count() != kSteps + 1) {
      throw std::runtime_error(linkage.name + " does not move: " +
                               (found.items().empty() ? "" : found.items().front().message));
    }
    motion_ = *std::move(motion);
    task_ = {.drives = motion_.solution.drives, .steps = kSteps};
  }

  // As if the motion reported these, too.
  void report_dynamics() { motion_.plan.report.dynamics = true; }

  void follow() { keep(solve_motion(motion_.network, task_)); }

  void run() {
    const MotionSolution solution = solve_motion(motion_.network, task_);
    MotionPositions positions(mechanism_,
                              motion_.plan,
                              motion_.network,
                              motion_.drawn,
                              detail_of(motion_.plan, mechanism_));
    for (int step = 0; step <= kSteps; ++step) {
      const MotionPosition position = positions.at(solution.configuration_at(step),
                                                   solution.shares[static_cast<std::size_t>(step)]);
      const auto first = static_cast<std::size_t>(mechanism_.topology.actuators.front().action);
      last_ = position.solved.value().action.value().magnitudes.at(first).value();
      keep(position);
    }
  }

  double last_action() const { return last_; }

 private:
  Mechanism mechanism_;
  FoundMotion motion_;
  MotionTask task_;
  double last_ = 0.0;
};

void demand_same(const std::string& name, double ours, double other) {
  if (!(std::abs(ours - other) <= kSameAction * std::abs(other))) {
    throw std::runtime_error(fmt::format("{}: {} as against {} of Simbody", name, ours, other));
  }
}

std::string measure_one(const MassLinkage& linkage, const Options& options) {
  const auto plain = std::make_shared<Rows>(linkage, false);
  const auto whole = std::make_shared<Rows>(linkage, true);
  const auto reported = std::make_shared<Rows>(linkage, true);
  reported->report_dynamics();
  std::vector<Job> jobs = {
      {linkage.name + ", with inertia", [whole] { whole->run(); }, kWithInertia, 1.0},
      {"  with the reduced equation", [reported] { reported->run(); }, {}, 1.0},
      {"  positions alone", [plain] { plain->follow(); }, {}, 1.0}};
#ifdef KINESTAT_HAS_SIMBODY
  const auto other = std::make_shared<SimbodyRows>(linkage);
  whole->run();
  other->run(kSteps);
  demand_same(linkage.name, whole->last_action(), other->last_action());
  jobs.push_back({"  Simbody", [other] { other->run(kSteps); }, {}, 1.0});
#endif
  const Interleaved result = measure([plain] { plain->run(); }, jobs, options.rounds);
  std::string text = write_ratios(result.ratios, "rows with weights", options.form);
  if (options.form == TableForm::text) {
    const double row = result.unit_seconds / (kSteps + 1);
    text += fmt::format("a row with weights takes {:.1f} µs here\n", 1e6 * row);
#ifdef KINESTAT_HAS_SIMBODY
    const double share = result.ratios.front().median / result.ratios.back().median;
    text += fmt::format("with inertia {:.3f} of Simbody (target {}: {})\n",
                        share,
                        kBesideSimbody,
                        share <= kBesideSimbody ? "held" : "missed");
#endif
  }
  return text;
}

std::string run(const Options& options) {
  std::string text;
  for (const MassLinkage& linkage : mass_linkages()) {
    text += measure_one(linkage, options);
  }
  return text;
}

}  // namespace

}  // namespace kinestat::bench

int main(int argc, char** argv) {
  return kinestat::bench::run_program("dynamics_bench", argc, argv, kinestat::bench::run);
}
