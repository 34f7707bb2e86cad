#include "draw/picture_title.hpp"

#include <fmt/format.h>

#include "report/report_parts.hpp"

namespace kinestat {

std::string shown_name(const std::string& file, const MechanismDescription& description) {
  if (!description.name.empty()) {
    return description.name;
  }
  return file == "-" ? "<stdin>" : file;
}

std::string picture_title(std::string_view what,
                          const std::string& file,
                          const MechanismDescription& description) {
  return fmt::format("{}: {}", what, shown_name(file, description));
}

std::string picture_title(std::string_view what, const Analysis& analysis) {
  return picture_title(what, analysis.file, analysis.description);
}

namespace {

std::string words_of_case(std::string_view what,
                          const CaseAnalysis& one,
                          const Analysis& analysis) {
  return fmt::format(
      "{}, case {}{}", what, one.which.label, in_drawn_position(analysis.description));
}

}  // namespace

std::string picture_title_of_case(std::string_view what,
                                  const CaseAnalysis& one,
                                  const Analysis& analysis) {
  return picture_title(words_of_case(what, one, analysis), analysis);
}

std::string words_of_cases(std::string_view what, const Analysis& analysis) {
  return analysis.cases.size() == 1
             ? words_of_case(what, analysis.cases.front(), analysis)
             : fmt::format("{}{}", what, in_drawn_position(analysis.description));
}

std::string picture_title_of_cases(std::string_view what, const Analysis& analysis) {
  return picture_title(words_of_cases(what, analysis), analysis);
}

}  // namespace kinestat
