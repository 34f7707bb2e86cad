// Times the search for all static input sets of the pulley, in units of a dense solve by LAPACK.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "dense_statics.hpp"
#include "inputs/input_sets.hpp"
#include "inputs/solution_space.hpp"
#include "interleave.hpp"
#include "ratio_table.hpp"
#include "subject.hpp"

namespace kinestat::bench {

namespace {

constexpr double kTarget = 3.0;
constexpr std::uint64_t kSets = 37;  // Alves 2023, Eq. 3.28 (with the ropes upright)

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

struct Options {
  int rounds = 300;
  TableForm form = TableForm::text;
};

Options read_options(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--csv") {
      options.form = TableForm::csv;
    } else if (word == "--rounds" && i + 1 < argc) {
      options.rounds = std::max(1, std::atoi(argv[++i]));
    } else {
      throw std::runtime_error("usage: inputs_bench [--rounds N] [--csv]");
    }
  }
  return options;
}

int run(int argc, char** argv) {
  const Options options = read_options(argc, argv);
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
  std::fwrite(text.data(), 1, text.size(), stdout);
  return 0;
}

}  // namespace

}  // namespace kinestat::bench

int main(int argc, char** argv) {
  try {
    return kinestat::bench::run(argc, argv);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "inputs_bench: %s\n", problem.what());
    return 1;
  }
}
