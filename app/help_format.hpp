// How --help looks: what the command does, examples, use, options.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace kinestat::app {

/// The footer of a command holds its examples, which come first.
class HelpFormat : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app,
                        std::string name,
                        CLI::AppFormatMode mode) const override;
};

}  // namespace kinestat::app
