#include "run/texts/explain.hpp"

#include "command.hpp"

namespace kinestat::app {

void add_explain(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat explain E0312\n"
      "  kinestat explain\n");
  auto code = std::make_shared<std::string>();
  add_argument(command, "CODE", *code, "the code in the brackets of a message");
  run_when_chosen(command, job, [code] { return explain(*code); });
}

}  // namespace kinestat::app
