#include "command.hpp"
#include "run/texts/library_file.hpp"

namespace kinestat::app {

namespace {

struct ExamplesOptions {
  std::string name;
  std::string path;
  Overwrite overwrite = Overwrite::own_only;
};

}  // namespace

void add_examples(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat examples\n"
      "  kinestat examples planar\n"
      "  kinestat examples rssr | less\n"
      "  kinestat examples transmissions/zf_8hp70 gearbox.yaml\n");
  auto options = std::make_shared<ExamplesOptions>();
  add_argument(command,
               "EXAMPLE",
               options->name,
               "a mechanism or a folder of the library; without\n"
               "it, all are listed");
  add_written_file(command, options->path, options->overwrite);
  run_when_chosen(command, job, [options] {
    return library_file(options->name, options->path, options->overwrite);
  });
}

}  // namespace kinestat::app
