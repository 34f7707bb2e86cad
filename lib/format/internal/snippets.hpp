// What editors offer to be filled in.
#pragma once

#include <string_view>

#include "format/internal/json.hpp"
#include "forms/form_shape.hpp"

namespace kinestat {

Json snippet(std::string_view label, const Json& body, std::string_view meaning = {});

/// Whether the example is a list, a mapping or a single value as the shape is.
bool fits(const FormShape& shape, const Json& example);

/// Of a list or a mapping: examples to be filled in.
Json snippets_of(const FormShape& shape, const Json& examples);

}  // namespace kinestat
