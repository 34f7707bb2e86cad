// Examples of declarations as JSON, and the snippets that editors offer, which follow from them.
#pragma once

#include <string>

#include "format/internal/json.hpp"
#include "forms/form_shape.hpp"

namespace kinestat {

/// The value of an example that is written as in a file: "{drive: in, to: 90 deg}".
Json example_json(const std::string& text);

/// Lists and mappings in brackets, each single value a placeholder: "{drive: ${1:in}}".
std::string flow_snippet(const Json& example);

/// Likewise with a line for each key of the outer mapping, as the value that stands for the lines.
Json line_snippet(const Json& example);

/// "{drive, to}", "[{body, at}]", "[velocity, d.wz]": the keys of an example, or its values.
std::string outline(const Json& example);

}  // namespace kinestat
