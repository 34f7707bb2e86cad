// How --help looks: what the command does, examples, use, options.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace kinestat::app {

/// Options and arguments that users are shown; the others have no group.
std::vector<const CLI::Option*> shown_options(const CLI::App& app);

/// Whether a word belongs to the option.
bool takes_value(const CLI::Option& option);

/// "FILE...", "[TOPIC]" and so on, as the use has it.
std::string argument_of(const CLI::Option& option);

/// What follows the name: "COMMAND [OPTION]...", "[OPTION]... FILE...".
std::string usage_of(const CLI::App& app);

/// The footer of a command holds its examples, which come first.
class HelpFormat : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app,
                        std::string name,
                        CLI::AppFormatMode mode) const override;
};

}  // namespace kinestat::app
