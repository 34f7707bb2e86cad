// Which JSON types the values of a shape have.
#pragma once

#include "format/internal/json.hpp"
#include "forms/form_shape.hpp"

namespace kinestat {

/// A word, or a list of them.
Json types_of(const FormShape& shape);

/// Whether it is always a list or a mapping, or nothing at all.
bool is_collection(const FormShape& shape);

}  // namespace kinestat
