// Times one synthesis task of five positions, in units of the singular values of its conditions.

#include <chrono>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/SVD>
#include <fmt/format.h>

#include "bench_program.hpp"
#include "core/types.hpp"
#include "interleave.hpp"
#include "math/numbers/for_each_number.hpp"
#include "ratio_table.hpp"
#include "studies/synthesis/dyads/precise_burmester.hpp"
#include "studies/synthesis/positions/specification.hpp"
#include "studies/synthesis/selection/selection.hpp"

namespace kinestat::bench {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

// All dyads, linkages and verdicts may cost 200 µs on a core on which the unit takes 3 µs or more.
constexpr double kTarget = 65.0;

using Positions = std::vector<PositionJets>;

// A crank-rocker in five positions: four real dyads and six four-bars, the most there are.
Positions finite_positions() {
  return {finite_position({0.581552593014371, 0.38368212248895894}, 0.4721943757718849),
          finite_position({0.15706132828548014, 0.977349558587791}, 0.274116014223641),
          finite_position({-0.6698577952420949, 1.0897675153749908}, 0.15870431586504097),
          finite_position({-1.28529867753234, -0.23927553986552447}, 0.29903554959787193),
          finite_position({0.1426801678725405, -0.9142181165987653}, 0.722066369178457)};
}

// do Valle 1983, table 5 with E and F as Burmester points: PPPPP, four real dyads.
Positions infinitesimal_positions() {
  return {*find_jets({.at = {0.0, 0.0},
                      .angle = 0.0,
                      .pole = Point(3.75, 3.25),
                      .curvature = CurvatureSpecification{{3.0, 2.6}, {0.75, 2.0}, 0.58},
                      .is_stationary = true,
                      .is_burmester = true})
               .jets};
}

// do Valle 1983, table 3 (PPP-P-P) with its effective freedom.
std::optional<Positions> table_3(std::span<const double> choice) {
  const auto first = find_jets({.at = {0.0, 0.0},
                                .angle = 30.0 * kDegree,
                                .pole = Point(3.75, 3.25),
                                .curvature = CurvatureSpecification{{3.0, 2.6}, {0.75, 2.0}, 0.58}},
                               {.s = choice[0]});
  return Positions{*first.jets,
                   finite_position({2.25, 1.2}, 52.0 * kDegree),
                   finite_position({4.0, 1.0}, 65.0 * kDegree)};
}

std::vector<LinkageCandidate> solve(const Positions& positions) {
  return rank_linkages(solve_burmester(positions).dyads, positions, {});
}

std::vector<PositionJetsOf<BigFloat>> with_many_digits(const Positions& positions) {
  std::vector<PositionJetsOf<BigFloat>> result;
  for (const PositionJets& position : positions) {
    result.push_back({.x = {BigFloat(position.x[0])},
                      .y = {BigFloat(position.y[0])},
                      .angle = {BigFloat(position.angle[0])}});
  }
  return result;
}

void singular_values(const MatX& matrix) {
  keep(Eigen::JacobiSVD<MatX>(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV).singularValues());
}

std::vector<Job> jobs_for() {
  const Positions finite = finite_positions();
  const Positions infinitesimal = infinitesimal_positions();
  const auto dyads = solve_burmester(finite).dyads;
  const auto digits = with_many_digits(finite);
  const CandidateMaker sample = candidates_of(table_3, {});
  return {
      {"P-P-P-P-P: dyads, linkages, verdicts", [=] { keep(solve(finite)); }, kTarget},
      {"  dyads", [=] { keep(solve_burmester(finite)); }, {}},
      {"  linkages and verdicts", [=] { keep(rank_linkages(dyads, finite, {})); }, {}},
      {"PPPPP: dyads, linkages, verdicts", [=] { keep(solve(infinitesimal)); }, kTarget},
      {"a sample of a selection, PPP-P-P", [=] { keep(sample(std::vector{-2.0})); }, kTarget},
      {"P-P-P-P-P: dyads with 100 digits", [=] { keep(solve_burmester_precisely(digits)); }, {}}};
}

std::string selection_time() {
  constexpr int kSamples = 100'000;
  const std::vector<SelectionRange> ranges = {{.from = -20.0, .to = 20.0, .count = kSamples}};
  const auto start = std::chrono::steady_clock::now();
  const Selection found =
      select_linkages(ranges, candidates_of(table_3, {}), 5, for_each_on_threads(2));
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return fmt::format("selection over {} samples, {} usable, on 2 threads: {:.1f} s (target 60)\n",
                     found.samples,
                     found.usable,
                     elapsed.count());
}

std::string run(const Options& options) {
  const MatX matrix = MatX::Random(4, 7);
  const Interleaved result = measure([&] { singular_values(matrix); }, jobs_for(), options.rounds);
  std::string text = write_ratios(result.ratios, "SVDs", options.form);
  if (options.form == TableForm::text) {
    text += fmt::format("SVD = singular values and vectors of a 4 x 7 matrix, here {:.2f} µs\n",
                        1e6 * result.unit_seconds);
    text += selection_time();
  }
  return text;
}

}  // namespace

}  // namespace kinestat::bench

int main(int argc, char** argv) {
  return kinestat::bench::run_program("synthesis_bench", argc, argv, kinestat::bench::run);
}
