#include "run/graph.hpp"

#include "command.hpp"

namespace kinestat::app {

namespace {

struct GraphOptions {
  FileOptions files;
  Matrices matrices = Matrices::none;
  std::string case_label;
};

void add_matrices(CLI::App& command, GraphOptions& options) {
  add_flag(
      command,
      "--matrices",
      [&options] { options.matrices = Matrices::all; },
      "also show every matrix of the method: I, Q, B,\n"
      "B_M, M_D, M_N, Q_A, A_D, A_N, their echelon forms\n"
      "and the partition of a case");
  with_value(command,
             command.add_option("--case",
                                options.case_label,
                                "the case whose known magnitudes partition M_N and\n"
                                "A_N; default: the first"),
             "CASE");
}

}  // namespace

void add_graph(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat graph mechanisms/planar/four_bar.yaml\n"
      "  kinestat graph --matrices --format csv --case 'gear 1' train.yaml\n");
  auto options = std::make_shared<GraphOptions>();
  add_files(command, options->files);
  add_format(command, options->files);
  add_strict(command, options->files);
  add_matrices(command, *options);
  run_when_chosen(command, job, [options] {
    return graph_files(
        options->files.paths, options->matrices, options->case_label, options->files.analyse);
  });
}

}  // namespace kinestat::app
