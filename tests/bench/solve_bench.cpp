// Times the solves of one case, and what surrounds them, in units of a dense solve by LAPACK.

#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench_program.hpp"
#include "cases/solve_cases.hpp"
#include "dense_statics.hpp"
#include "format/mechanism_reader.hpp"
#include "interleave.hpp"
#include "io/read_file.hpp"
#include "io/yaml_tree.hpp"
#include "kinematics/velocity.hpp"
#include "mechanism/bind/bind.hpp"
#include "network/bases.hpp"
#include "network/node_system.hpp"
#include "report/file/file_report.hpp"
#include "run/analyse.hpp"
#include "statics/action.hpp"
#include "studies/mobility/mobility_counts.hpp"
#include "subject.hpp"

namespace kinestat::bench {

namespace {

constexpr double kTarget = 2.0;

/// One linear system with the columns and values of its primaries.
struct System {
  SparseMatrix matrix;
  std::vector<int> columns;
  std::vector<double> known;
};

// The parts of one solve: scaling, factors, the check of the primaries, and the substitution.
void add_parts(const std::string& name, const System& system, std::vector<Job>& jobs) {
  jobs.push_back({"  find_scaling" + name, [&] { keep(find_scaling(system.matrix)); }, {}});
  jobs.push_back(
      {"  Elimination" + name, [&] { keep(Elimination(system.matrix, system.columns)); }, {}});
  const Elimination factors(system.matrix, system.columns);
  const std::vector<double> units(static_cast<std::size_t>(system.matrix.columns), 1.0);
  jobs.push_back(
      {"  check_primaries" + name, [=] { keep(check_primaries(factors, {}, units)); }, {}});
  jobs.push_back(
      {"  Elimination::solve" + name, [=, &system] { keep(factors.solve(system.known, {})); }, {}});
}

struct Systems {
  System velocity;
  System action;
};

Systems systems_of(const Subject& subject) {
  const Mechanism& mechanism = subject.loaded.mechanism;
  const Topology& topology = mechanism.topology;
  Systems systems;
  systems.velocity.matrix = velocity_system(topology, mechanism.geometry, subject.motion);
  systems.action.matrix = action_system(topology, mechanism.geometry, subject.action);
  for (const Primary& primary : subject.which.motions) {
    systems.velocity.columns.push_back(velocity_column(topology, subject.motion, primary.index));
    systems.velocity.known.push_back(primary.value);
  }
  for (const Primary& primary : subject.which.actions) {
    systems.action.columns.push_back(primary.index);
    systems.action.known.push_back(primary.value);
  }
  return systems;
}

void add_solves(const Subject& subject, const Systems& systems, std::vector<Job>& jobs) {
  const Mechanism& mechanism = subject.loaded.mechanism;
  jobs.push_back({"one kinematic and one static solve",
                  [&] {
                    keep(motion_of(subject));
                    keep(action_of(subject));
                  },
                  kTarget});
  jobs.push_back({"solve_velocity", [&] { keep(motion_of(subject)); }, {}});
  jobs.push_back(
      {"  velocity_system",
       [&] { keep(velocity_system(mechanism.topology, mechanism.geometry, subject.motion)); },
       {}});
  add_parts(" (velocity)", systems.velocity, jobs);
  jobs.push_back({"solve_action", [&] { keep(action_of(subject)); }, {}});
  jobs.push_back(
      {"  action_system",
       [&] { keep(action_system(mechanism.topology, mechanism.geometry, subject.action)); },
       {}});
  add_parts(" (action)", systems.action, jobs);
}

void add_reading(const Subject& subject, std::vector<Job>& jobs) {
  jobs.push_back({"read_file",
                  [&] {
                    Diagnostics found;
                    keep(read_file(subject.path, {}, found));
                  },
                  {}});
  jobs.push_back({"read_yaml",
                  [&] {
                    Diagnostics found;
                    keep(read_yaml(subject.source, {}, found));
                  },
                  {}});
  jobs.push_back({"read_mechanism",
                  [&] {
                    Diagnostics found;
                    keep(read_mechanism(subject.tree, found));
                  },
                  {}});
  jobs.push_back({"bind",
                  [&] {
                    Diagnostics found;
                    keep(bind(subject.loaded.description, found));
                  },
                  {}});
}

void add_report(const std::string& name,
                const Analysis& analysis,
                const ReportForms& forms,
                std::vector<Job>& jobs) {
  jobs.push_back({name,
                  [&analysis, forms] {
                    Diagnostics found;
                    keep(make_report(analysis, {}, nullptr, forms, found));
                  },
                  {}});
}

void add_analysis(const Subject& subject, const Analysis& analysis, std::vector<Job>& jobs) {
  const Mechanism& mechanism = subject.loaded.mechanism;
  jobs.push_back({"motion_basis and action_basis",
                  [&] {
                    keep(motion_basis(mechanism.geometry, mechanism.kinematic_order));
                    keep(action_basis(mechanism.geometry, mechanism.static_order));
                  },
                  {}});
  jobs.push_back({"count_motions", [&] { keep(count_motions(mechanism, mechanism)); }, {}});
  jobs.push_back(
      {"solve_cases (all cases)", [&] { keep(solve_cases(subject.path, subject.loaded)); }, {}});
  add_report("report, published values only", analysis, {}, jobs);
  add_report("report, table", analysis, {.text = true}, jobs);
  add_report("report, JSON", analysis, {.json = true}, jobs);
  AnalyseOptions quiet;
  quiet.is_quiet = true;
  jobs.push_back({"analyse_files, quiet",
                  [&subject, quiet] { keep(analyse_files({subject.path}, quiet)); },
                  {}});
}

std::string run(const Options& options) {
  const Subject subject = read_subject(KINESTAT_MECHANISM, "M1");
  const Mechanism& mechanism = subject.loaded.mechanism;
  DenseStatics dense(mechanism, subject.action, subject.which);
  if (!dense.is_square() || !dense.agrees(mechanism.topology, action_of(subject))) {
    throw std::runtime_error("solve_action and dgesv disagree");
  }
  const Systems systems = systems_of(subject);
  const Analysis analysis = solve_cases(subject.path, subject.loaded);
  std::vector<Job> jobs;
  add_solves(subject, systems, jobs);
  jobs.push_back({"copy of A_NS, part of D", [&] { dense.copy(); }, {}});
  add_reading(subject, jobs);
  add_analysis(subject, analysis, jobs);
  const Interleaved result = measure([&] { dense.solve(); }, jobs, options.rounds);
  std::string text = write_ratios(result.ratios, "D", options.form);
  if (options.form == TableForm::text) {
    text += fmt::format(
        "D = dgesv of {0} x {0}, here {1:.1f} µs\n", dense.size(), 1e6 * result.unit_seconds);
  }
  return text;
}

}  // namespace

}  // namespace kinestat::bench

int main(int argc, char** argv) {
  return kinestat::bench::run_program("solve_bench", argc, argv, kinestat::bench::run);
}
