#include "run/explain.hpp"

#include "command.hpp"

namespace kinestat::app {

void add_explain(CLI::App& parent, Job& job) {
  CLI::App* command =
      parent.add_subcommand("explain", "explain a diagnostic code such as E0312, or list all");
  auto code = std::make_shared<std::string>();
  command->add_option("CODE", *code, "the code in brackets of a message");
  command->callback([code, &job] { job = [code] { return explain(*code); }; });
}

}  // namespace kinestat::app
