#include "run/graph.hpp"

#include "command.hpp"

namespace kinestat::app {

namespace {

struct GraphOptions {
  FileOptions files;
  bool matrices = false;
  std::string case_label;
};

}  // namespace

void add_graph(CLI::App& parent, Job& job) {
  CLI::App* command =
      parent.add_subcommand("graph", "show the coupling graph: tree, circuits, cut-sets");
  auto options = std::make_shared<GraphOptions>();
  add_files(*command, options->files);
  add_format(*command, options->files);
  command->add_flag("--matrices",
                    options->matrices,
                    "also every matrix of the method: I, Q, B, B_M, M_D, M_N, Q_A, A_D, A_N, their "
                    "echelon forms and the partition of a case");
  command
      ->add_option("--case",
                   options->case_label,
                   "the case whose known magnitudes partition M_N and A_N; default the first")
      ->type_name("LABEL");
  command->footer(
      "Examples:\n"
      "  kinestat graph mechanisms/planar/four_bar.yaml\n"
      "  kinestat graph --matrices --format csv --case M1 train.yaml");
  command->callback([options, &job] {
    job = [options] {
      return graph_files(options->files.paths,
                         options->matrices ? Matrices::all : Matrices::none,
                         options->case_label,
                         options->files.analyse);
    };
  });
}

}  // namespace kinestat::app
