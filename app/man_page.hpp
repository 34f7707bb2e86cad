// Pages of the manual for man(1), from the same texts as the help.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace kinestat::app {

/// kinestat(1): what the program is for, and its commands; the pages of both and of the topics.
std::string man_page_of_program(const CLI::App& app, const std::vector<std::string>& topics);

/// kinestat-COMMAND(1). `exit_status` is the text of that topic.
std::string man_page_of_command(const CLI::App& command, std::string_view exit_status);

/// kinestat-TOPIC(7): the page of help as it is, whose first line is its title.
std::string man_page_of_topic(std::string_view name, std::string_view page);

}  // namespace kinestat::app
