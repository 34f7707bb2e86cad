// Times what a search for transmissions is made of, in units of a determinant of four by four.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "bench_program.hpp"
#include "interleave.hpp"
#include "ratio_table.hpp"
#include "studies/transmissions/corner_ranges.hpp"
#include "studies/transmissions/search.hpp"

namespace kinestat::bench {

namespace {

using Matrix = std::array<std::array<double, 4>, 4>;

// By elimination with pivots of the columns.
double determinant(Matrix m) {
  double result = 1.0;
  for (std::size_t k = 0; k < m.size(); ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < m.size(); ++i) {
      pivot = std::abs(m[i][k]) > std::abs(m[pivot][k]) ? i : pivot;
    }
    std::swap(m[k], m[pivot]);
    result *= pivot == k ? m[k][k] : -m[k][k];
    for (std::size_t i = k + 1; i < m.size(); ++i) {
      const double factor = m[i][k] / m[k][k];
      for (std::size_t j = k + 1; j < m.size(); ++j) {
        m[i][j] -= factor * m[k][j];
      }
    }
  }
  return result;
}

// A thousand of them, so that the clock does not count.
constexpr int kDeterminants = 1000;

void determinants() {
  Matrix m;
  for (std::size_t i = 0; i < m.size(); ++i) {
    for (std::size_t j = 0; j < m.size(); ++j) {
      m[i][j] = std::cos(static_cast<double>(4 * i + j + 1));
    }
  }
  for (int i = 0; i < kDeterminants; ++i) {
    m[0][0] = 1.0 + i;
    keep(determinant(m));
  }
}

TransmissionTask six_gears() {
  TransmissionTask task{.simple_sets = 3,
                        .elements = 5,
                        .engaged = 2,
                        .ladder = {.forward = 6,
                                   .reverse = 1,
                                   .needs_direct = true,
                                   .first = {3.83, 4.77},
                                   .last = {0.61, 0.77},
                                   .step = {1.13, 1.87},
                                   .reverse_ratio = {2.33, 3.87}}};
  task.stationary_ratios[0] = {.range = {1.6, 2.8}, .values = {1.6, 1.8, 2.0, 2.2, 2.4, 2.6, 2.8}};
  task.losses = {0.02, 0.03};
  return task;
}

TransmissionTask eight_gears() {
  TransmissionTask task{.simple_sets = 4,
                        .elements = 5,
                        .engaged = 3,
                        .ladder = {.forward = 8,
                                   .reverse = 1,
                                   .needs_direct = true,
                                   .first = {4.03, 5.47},
                                   .spread = {6.53, 8.97},
                                   .step = {1.13, 1.77},
                                   .reverse_ratio = {2.53, 4.97}}};
  task.stationary_ratios[0] = {.range = {1.6, 3.6}, .values = {1.6, 2.0, 2.8, 3.6}};
  task.losses = {0.02, 0.03};
  return task;
}

// The layouts of one structure over the whole box of stationary ratios, for roles of the sets.
class RootTest {
 public:
  RootTest(const TransmissionTask& task, std::size_t number)
      : structure_(enumerate_structures(task.sets(), task.engaged, 0)[number]),
        train_(structure_, task.engaged),
        bounds_(task.ladder),
        roles_(least_role_choices(task.sets(), 0, {})),
        table_(train_) {
    const std::vector<TransmissionLayout> layouts =
        find_layouts(train_, task.elements, task.ladder.forward + task.ladder.reverse, 0);
    for (const TransmissionLayout& layout : layouts) {
      for (const LayoutGear& gear : layout.gears) {
        states_.push_back(gear.state);
      }
    }
    std::ranges::sort(states_);
    states_.erase(std::unique(states_.begin(), states_.end()), states_.end());
    for (const TransmissionLayout& layout : layouts) {
      std::vector<std::size_t> places;
      for (const LayoutGear& gear : layout.gears) {
        places.push_back(static_cast<std::size_t>(std::ranges::lower_bound(states_, gear.state) -
                                                  states_.begin()));
      }
      layouts_.emplace_back(LadderWalk(train_, layout, bounds_), std::move(places));
    }
    for (std::size_t s = 0; s < static_cast<std::size_t>(task.sets()); ++s) {
      box_.from[s] = task.stationary_ratios[0].range.from;
      box_.to[s] = task.stationary_ratios[0].range.to;
    }
    ranges_.resize(states_.size());
  }

  double states() const { return static_cast<double>(states_.size()); }

  double layouts() const { return static_cast<double>(layouts_.size()); }

  void find_coordinates() { table_.set_corners(roles_[at_++ % roles_.size()], box_); }

  void find_ranges() { table_.ranges(states_, ranges_); }

  void run() {
    find_coordinates();
    find_ranges();
    std::array<ClosedRange, kMostGears> its;
    for (const auto& [walk, places] : layouts_) {
      for (std::size_t g = 0; g < places.size(); ++g) {
        its[g] = ranges_[places[g]];
      }
      keep(walk.may_have_ladder(std::span(its).first(places.size())));
    }
  }

 private:
  TransmissionStructure structure_;
  GenericTrain train_;
  LadderBounds bounds_;
  std::vector<RoleChoice> roles_;
  RatioTable table_;
  std::vector<std::uint32_t> states_;
  std::vector<std::pair<LadderWalk, std::vector<std::size_t>>> layouts_;
  StationaryBox box_;
  std::vector<ClosedRange> ranges_;
  std::size_t at_ = 0;
};

std::string search_time() {
  const auto start = std::chrono::steady_clock::now();
  const TransmissionSearch search = search_transmissions(six_gears(), one_after_another);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return fmt::format(
      "six gears of three sets, {} layouts with roles, {} found: {:.2f} s (target 2)\n",
      search.stages.labelled_layouts,
      search.stages.found,
      elapsed.count());
}

std::string run(const Options& options) {
  RootTest three(six_gears(), 99);
  RootTest four(eight_gears(), 1435);
  constexpr double kCorners = 16.0;
  const std::vector<Job> jobs = {{"coordinates of a structure of four sets, a corner",
                                  [&] { four.find_coordinates(); },
                                  1.0,
                                  kCorners / kDeterminants},
                                 {"ratio of a state at a corner",
                                  [&] { four.find_ranges(); },
                                  0.1,
                                  kCorners * four.states() / kDeterminants},
                                 {"layout with roles over a box, three sets",
                                  [&] { three.run(); },
                                  6.0,
                                  three.layouts() / kDeterminants},
                                 {"layout with roles over a box, four sets",
                                  [&] { four.run(); },
                                  15.0,
                                  four.layouts() / kDeterminants}};
  const Interleaved result = measure(determinants, jobs, options.rounds);
  std::string text = write_ratios(result.ratios, "D", options.form);
  if (options.form == TableForm::text) {
    text += fmt::format("D = determinant of a 4 x 4 matrix, here {:.0f} ns\n",
                        1e9 * result.unit_seconds / kDeterminants);
    text += search_time();
  }
  return text;
}

}  // namespace

}  // namespace kinestat::bench

int main(int argc, char** argv) {
  return kinestat::bench::run_program("transmission_bench", argc, argv, kinestat::bench::run);
}
