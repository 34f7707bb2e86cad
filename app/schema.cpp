#include "command.hpp"
#include "core/page_text.hpp"
#include "core/text.hpp"
#include "run/texts/schema_text.hpp"

namespace kinestat::app {

void add_schema(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat schema > mechanism.schema.json\n"
      "  kinestat schema report\n");
  auto name = std::make_shared<std::string>("mechanism");
  std::string meaning = "mechanism (default), or an output:\n" +
                        page_lines("", plain_list(schema_names(), schema_names().size()), 0, 50);
  meaning.pop_back();
  add_argument(command, "SCHEMA", *name, meaning);
  run_when_chosen(command, job, [name] { return schema_text(*name); });
}

}  // namespace kinestat::app
