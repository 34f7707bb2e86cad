// The kinds of numbers in a mechanism file; each may be an expression.
#pragma once

#include <string>

#include "description/value.hpp"
#include "format/form.hpp"

namespace kinestat {

/// A number with its range: of a bare number, which the schema knows. What an expression comes to
/// is judged when it is bound.
Form<Value> number_form(std::string definition,
                        std::string meaning,
                        std::vector<std::string> examples,
                        NumberRange range = {});

Form<Value> length();
Form<Value> drawn_position();  ///< of a freedom, from the drawn position
Form<Value> step_count();

}  // namespace kinestat
