// Times the derivatives of one value towards all parameters, in units of the solves of its case.

#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench_program.hpp"
#include "interleave.hpp"
#include "mechanism/bind/bind.hpp"
#include "mechanism/bind/derivatives.hpp"
#include "ratio_table.hpp"
#include "studies/sensitivity/adjoint.hpp"
#include "subject.hpp"

namespace kinestat::bench {

namespace {

constexpr double kTarget = 2.0;
// The first depends on the actions alone, the second on the rates, the third on both.
constexpr const char* kValues[] = {"torque_ratio", "ratio", "power/input"};

// What `kinestat sensitivity` holds when it asks for derivatives.
struct Start {
  std::vector<int> parameters;
  KinematicSolution motion;
  StaticSolution action;
  MechanismDerivatives derivatives;
  AdjointBases bases;
};

Start make_start(const Subject& subject) {
  Start start;
  for (std::size_t i = 0; i < subject.loaded.description.parameters.size(); ++i) {
    start.parameters.push_back(static_cast<int>(i));
  }
  start.motion = motion_of(subject);
  start.action = action_of(subject);
  start.derivatives =
      bind_derivatives(subject.loaded.description, subject.loaded.mechanism, start.parameters);
  start.bases = find_adjoint_bases(subject.loaded.mechanism, start.derivatives);
  return start;
}

DualCase dual_case(const Subject& subject, const Start& start) {
  return {subject.loaded.mechanism,
          static_cast<std::size_t>(subject.case_index),
          &start.motion,
          &start.action,
          start.derivatives};
}

std::vector<std::optional<double>> all_derivatives(const Subject& subject,
                                                   const Start& start,
                                                   const char* value) {
  const DualCase values = dual_case(subject, start);
  CaseAdjoint adjoint(values, start.bases);
  return adjoint.derivatives_of(find_reported_value(values, value).value());
}

void solve_both(const Subject& subject) {
  keep(motion_of(subject));
  keep(action_of(subject));
}

std::vector<Job> jobs_for(const Subject& subject, const Start& start) {
  std::vector<Job> jobs;
  for (const char* value : kValues) {
    jobs.push_back({fmt::format("{} by all parameters", value),
                    [&subject, &start, value] { keep(all_derivatives(subject, start, value)); },
                    kTarget});
  }
  jobs.push_back({"bind_derivatives, once a file",
                  [&] {
                    keep(bind_derivatives(
                        subject.loaded.description, subject.loaded.mechanism, start.parameters));
                  },
                  {}});
  jobs.push_back({"find_adjoint_bases, once a file",
                  [&] { keep(find_adjoint_bases(subject.loaded.mechanism, start.derivatives)); },
                  {}});
  jobs.push_back({"bind and solve again for each parameter",
                  [&] {
                    for (std::size_t i = 0; i < start.parameters.size(); ++i) {
                      Diagnostics found;
                      keep(bind(subject.loaded.description, found));
                      solve_both(subject);
                    }
                  },
                  {}});
  return jobs;
}

std::string run(const Options& options) {
  const Subject subject = read_subject(KINESTAT_MECHANISM, "M1");
  const Start start = make_start(subject);
  const Interleaved result =
      measure([&] { solve_both(subject); }, jobs_for(subject, start), options.rounds);
  std::string text = write_ratios(result.ratios, "solves", options.form);
  if (options.form == TableForm::text) {
    text +=
        fmt::format("solves = one kinematic and one static solve, here {:.1f} µs; {} parameters\n",
                    1e6 * result.unit_seconds,
                    start.parameters.size());
  }
  return text;
}

}  // namespace

}  // namespace kinestat::bench

int main(int argc, char** argv) {
  return kinestat::bench::run_program("sensitivity_bench", argc, argv, kinestat::bench::run);
}
