// JSON Schemas of what the program writes, from its records.
#pragma once

#include <span>
#include <string>

namespace kinestat {

/// A schema and the name by which it is asked for.
struct NamedSchema {
  std::string name;
  std::string text;  ///< draft 07
};

/// Of every JSON that has a record.
std::span<const NamedSchema> record_schemas();

}  // namespace kinestat
