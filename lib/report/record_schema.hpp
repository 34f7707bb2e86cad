// The JSON Schema of what the program writes, from its record.
#pragma once

#include <string>
#include <string_view>

#include "record/shape.hpp"

namespace kinestat {

/// Draft 07; the name is that by which the schema is asked for.
std::string schema_text_of(std::string_view name, const RecordShape& record);

}  // namespace kinestat
