#include "command.hpp"
#include "core/text.hpp"
#include "run/schema_text.hpp"

namespace kinestat::app {

void add_schema(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat schema > mechanism.schema.json\n"
      "  kinestat schema report\n");
  auto name = std::make_shared<std::string>("mechanism");
  add_argument(command,
               "SCHEMA",
               *name,
               "mechanism (default) or what is written:\n" + plain_list(schema_names()));
  run_when_chosen(command, job, [name] { return schema_text(*name); });
}

}  // namespace kinestat::app
