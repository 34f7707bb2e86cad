// Times the search for all static input sets of the pulley, in units of a dense solve by LAPACK.

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench_program.hpp"
#include "dense_statics.hpp"
#include "interleave.hpp"
#include "ratio_table.hpp"
#include "studies/inputs/input_sets.hpp"
#include "studies/inputs/solution_space.hpp"
#include "subject.hpp"

namespace kinestat::bench {

namespace {

constexpr double kTarget = 3.0;
constexpr std::uint64_t kSets = 37;  // Alves 2023, Eq. 3.28 (with the cables upright)

InputSets sets_of(const MatX& solutions, std::size_t listed) {
  return find_input_sets(solutions, {.among = {}, .required = {}, .listed = listed});
}

std::vector<Job> jobs_for(const Subject& subject, const SolutionSpace& space) {
  const Mechanism& mechanism = subject.loaded.mechanism;
  const std::size_t all = kSets;
  std::vector<Job> jobs;
  jobs.push_back(
      {"null space and all 37 sets",
       [&subject, &mechanism] { keep(sets_of(action_space(mechanism, subject.action).basis, 0)); },
       kTarget});
  jobs.push_back({"  null space", [&] { keep(action_space(mechanism, subject.action)); }, {}});
  jobs.push_back({"  all 37 sets", [&space] { keep(sets_of(space.basis, 0)); }, {}});
  jobs.push_back({"all 37 sets, ranked by conditioning",
                  [&space, all] { keep(sets_of(space.basis, all)); },
                  {}});
  return jobs;
}

std::string run(const Options& options) {
  const Subject subject = read_subject(KINESTAT_MECHANISM, "block moves");
  const Mechanism& mechanism = subject.loaded.mechanism;
  DenseStatics dense(mechanism, subject.action, subject.which);
  if (!dense.is_square() || !dense.agrees(mechanism.topology, action_of(subject))) {
    throw std::runtime_error("solve_action and dgesv disagree");
  }
  const SolutionSpace space = action_space(mechanism, subject.action);
  if (sets_of(space.basis, 0).count() != kSets) {
    throw std::runtime_error("the pulley does not have 37 static sets");
  }
  const Interleaved result =
      measure([&] { dense.solve(); }, jobs_for(subject, space), options.rounds);
  std::string text = write_ratios(result.ratios, "D", options.form);
  if (options.form == TableForm::text) {
    text += fmt::format(
        "D = dgesv of {0} x {0}, here {1:.2f} µs\n", dense.size(), 1e6 * result.unit_seconds);
  }
  return text;
}

}  // namespace

}  // namespace kinestat::bench

int main(int argc, char** argv) {
  return kinestat::bench::run_program("inputs_bench", argc, argv, kinestat::bench::run);
}
