#include "command.hpp"
#include "core/page_text.hpp"
#include "core/text.hpp"
#include "run/texts/starter.hpp"

namespace kinestat::app {

namespace {

struct NewOptions {
  std::string kind;
  std::string path;
  Overwrite overwrite = Overwrite::own_only;
};

// Beside the names of arguments.
std::string kinds_in_lines() {
  constexpr std::size_t kWidth = 54;
  const std::vector<std::string> kinds = starter_kinds();
  std::string text = page_lines("", plain_list(kinds, kinds.size()), 0, kWidth);
  text.pop_back();
  return text;
}

}  // namespace

void add_new(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat new four-bar crank.yaml\n"
      "  kinestat new shift | less\n");
  auto options = std::make_shared<NewOptions>();
  add_argument(command, "KIND", options->kind, kinds_in_lines()).option_text("KIND");
  add_written_file(command, options->path, options->overwrite);
  run_when_chosen(command, job, [options] {
    return write_starter(options->kind, options->path, options->overwrite);
  });
}

}  // namespace kinestat::app
