// The JSON Schema of mechanism files, from the declarations of their sections.
#pragma once

#include <string>

namespace kinestat {

/// Draft 07, as the file schemas/mechanism.schema.json has it.
std::string mechanism_schema();

}  // namespace kinestat
