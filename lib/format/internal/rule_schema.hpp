// How keys belong together, as JSON Schema.
#pragma once

#include <string_view>

#include "format/internal/json.hpp"
#include "forms/form_shape.hpp"

namespace kinestat {

/// Whether another key may stand instead of it.
bool is_replaceable(const FormShape& shape, std::string_view key);

/// That at least one of the keys is there.
void add_any_of(const SharedList<std::string_view>& keys, Json& schema);

/// Adds the rules of a mapping or list to its schema.
void add_rules(const FormShape& shape, Json& schema);

}  // namespace kinestat
