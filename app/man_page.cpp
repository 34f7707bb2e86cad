#include "man_page.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "core/version.hpp"
#include "help_format.hpp"

namespace kinestat::app {

namespace {

// Of a character what is printed as it is: some formatters take these for others.
std::string as_roff(char c) {
  switch (c) {
    case '\\':
      return "\\e";
    case '-':
      return "\\-";
    case '\'':
      return "\\(aq";
    case '`':
      return "\\(ga";
    case '^':
      return "\\(ha";
    case '~':
      return "\\(ti";
    default:
      return {c};
  }
}

// Escaped for roff: no character is taken for a command, and a hyphen can be searched and copied.
std::string roff(std::string_view text) {
  std::string result;
  bool begins_line = true;
  for (const char c : text) {
    if (begins_line && c == '.') {
      result += "\\&";
    }
    result += as_roff(c);
    begins_line = c == '\n';
  }
  return result;
}

// Lines that were broken for the help flow again.
std::string flowing(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return roff(text);
}

std::string bold(std::string_view text) {
  return "\\fB" + roff(text) + "\\fR";
}

std::string italic(std::string_view text) {
  return "\\fI" + roff(text) + "\\fR";
}

// Lines as they are.
std::string verbatim(std::string_view text) {
  return ".nf\n" + roff(text) + (text.ends_with('\n') ? "" : "\n") + ".fi\n";
}

std::string head(std::string name, int section, std::string_view what) {
  std::string title = name;
  std::ranges::transform(
      title, title.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return fmt::format(".TH {} {} \"\" \"kinestat {}\" \"kinestat\"\n.SH NAME\n{} \\- {}\n",
                     roff(title),
                     section,
                     kVersion,
                     roff(name),
                     roff(what));
}

// "\fB-o\fR, \fB--out\fR \fIFOLDER\fR"
std::string bold_names_of(const CLI::Option& option) {
  std::string text;
  for (const std::string& name : CLI::detail::split(option.get_name(false, true), ',')) {
    text += (text.empty() ? "" : ", ") + bold(name);
  }
  return takes_value(option) ? text + " " + italic(option.get_type_name()) : text;
}

std::string entry(const std::string& term, const std::string& meaning) {
  return ".TP\n" + term + "\n" + flowing(meaning) + "\n";
}

std::string argument_entries(const CLI::App& app) {
  std::string text;
  for (const CLI::Option* option : shown_options(app)) {
    if (option->get_positional()) {
      text += entry(italic(argument_of(*option)), option->get_description());
    }
  }
  return text.empty() ? text : ".SH ARGUMENTS\n" + text;
}

std::string option_entries(const CLI::App& app) {
  std::string text = ".SH OPTIONS\n";
  for (const CLI::Option* option : shown_options(app)) {
    if (option->nonpositional()) {
      text += entry(bold_names_of(*option), option->get_description());
    }
  }
  return text;
}

// A page of help without its title.
std::string_view body_of(std::string_view page) {
  page.remove_prefix(std::min(page.size(), page.find('\n')));
  page.remove_prefix(std::min(page.size(), page.find_first_not_of('\n')));
  return page;
}

// Without its full stop, as a line of whatis(1).
std::string summary_of(const CLI::App& app) {
  std::string summary = app.get_description();
  return summary.ends_with('.') ? summary.substr(0, summary.size() - 1) : summary;
}

}  // namespace

std::string man_page_of_program(const CLI::App& app, const std::vector<std::string>& topics) {
  std::string also;
  for (const std::string& topic : topics) {
    also += (also.empty() ? "" : ", ") + bold("kinestat-" + topic) + "(7)";
  }
  std::string commands = ".SH COMMANDS\n";
  for (const CLI::App* command : app.get_subcommands({})) {
    commands += ".TP\n" + bold("kinestat-" + command->get_name()) + "(1)\n" +
                flowing(command->get_description()) + "\n";
  }
  return head("kinestat", 1, summary_of(app)) + ".SH SYNOPSIS\n" + bold("kinestat") + " " +
         italic(usage_of(app)) + "\n" + commands + option_entries(app) + ".SH EXAMPLES\n" +
         verbatim(app.get_footer()) + ".SH SEE ALSO\n" + also + "\n";
}

std::string man_page_of_command(const CLI::App& command, std::string_view exit_status) {
  return head("kinestat-" + command.get_name(), 1, summary_of(command)) + ".SH SYNOPSIS\n" +
         bold("kinestat " + command.get_name()) + " " + italic(usage_of(command)) + "\n" +
         argument_entries(command) + option_entries(command) + ".SH EXAMPLES\n" +
         verbatim(command.get_footer()) + ".SH EXIT STATUS\n" + verbatim(body_of(exit_status)) +
         ".SH SEE ALSO\n" + bold("kinestat") + "(1)\n";
}

std::string man_page_of_topic(std::string_view name, std::string_view page) {
  const std::string_view first = page.substr(0, page.find('\n'));
  const std::size_t colon = first.find(": ");
  const std::string_view title = colon == std::string_view::npos ? first : first.substr(colon + 2);
  return head(fmt::format("kinestat-{}", name), 7, title) + ".SH DESCRIPTION\n" +
         verbatim(body_of(page)) + ".SH SEE ALSO\n" + bold("kinestat") + "(1)\n";
}

}  // namespace kinestat::app
