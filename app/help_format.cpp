#include "help_format.hpp"

#include <sstream>

#include "core/page_text.hpp"

namespace kinestat::app {

namespace {

constexpr std::size_t kCommandColumn = 14;
constexpr std::size_t kOptionColumn = 28;

std::string commands_of(const CLI::App& app) {
  std::string list;
  for (const CLI::App* command : app.get_subcommands({})) {
    list += page_lines("  " + command->get_name(), command->get_description(), kCommandColumn);
  }
  return list.empty() ? "" : "\nCommands:\n" + list;
}

std::string options_of(const CLI::App& app) {
  std::ostringstream list;
  for (const CLI::Option* option : shown_options(app)) {
    if (option->nonpositional()) {
      const std::string type = takes_value(*option) ? " " + option->get_type_name() : "";
      CLI::detail::format_help(
          list, option->get_name(false, true) + type, option->get_description(), kOptionColumn);
    }
  }
  return "\nOptions:\n" + list.str();
}

}  // namespace

std::vector<const CLI::Option*> shown_options(const CLI::App& app) {
  return app.get_options([](const CLI::Option* option) { return !option->get_group().empty(); });
}

bool takes_value(const CLI::Option& option) {
  return option.get_expected_max() > 0;
}

// A text of its own marks an argument that is needed, but missed by the command itself.
std::string argument_of(const CLI::Option& option) {
  const bool is_list = option.get_expected_max() >= CLI::detail::expected_max_vector_size;
  const std::string name = option.get_name(true) + (is_list ? "..." : "");
  const bool is_needed = option.get_required() || !option.get_option_text().empty();
  return is_needed ? name : "[" + name + "]";
}

std::string usage_of(const CLI::App& app) {
  std::string use = app.get_subcommands({}).empty() ? "[OPTION]..." : "COMMAND [OPTION]...";
  for (const CLI::Option* option : shown_options(app)) {
    if (option->get_positional()) {
      use += " " + argument_of(*option);
    }
  }
  return use;
}

std::string HelpFormat::make_help(const CLI::App* app,
                                  std::string name,
                                  CLI::AppFormatMode /*mode*/) const {
  std::ostringstream list;
  for (const CLI::Option* option : shown_options(*app)) {
    if (option->get_positional()) {
      CLI::detail::format_help(
          list, argument_of(*option), option->get_description(), kOptionColumn);
    }
  }
  const std::string arguments = list.str().empty() ? "" : "\n" + list.str();
  return app->get_description() + "\n\nExamples:\n" + app->get_footer() + "\nUsage: " + name + " " +
         usage_of(*app) + "\n" + arguments + commands_of(*app) + options_of(*app);
}

}  // namespace kinestat::app
