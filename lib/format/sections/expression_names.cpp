#include "format/sections/expression_names.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "expression/functions.hpp"
#include "expression/parameters.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

// What else in an expression has this name.
std::string_view meaning_of(std::string_view reserved) {
  if (find_unit(reserved) != nullptr) {
    return "a unit";
  }
  if (find_function(reserved) != nullptr) {
    return "a function";
  }
  return is_condition_word(reserved) ? "a word of conditions" : "a constant";
}

}  // namespace

void check_expression_name(const Name& name, std::string_view kind, Diagnostics& found) {
  if (is_reserved_name(name.text)) {
    found.error(
        "E0306",
        name.where,
        fmt::format(
            "a {} cannot be named '{}', which is {}", kind, name.text, meaning_of(name.text)),
        fmt::format("call it '{}_1', or by a longer word", name.text));
  } else if (name.text.find('-') != std::string::npos) {
    std::string better = name.text;
    std::ranges::replace(better, '-', '_');
    found.error("E0306",
                name.where,
                fmt::format("{} '{}' would be read as a difference", kind, name.text),
                fmt::format("call it '{}'", better));
  } else {
    check_name(name, fmt::format("a {}", kind), found);
  }
}

}  // namespace kinestat
