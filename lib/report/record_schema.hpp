// JSON Schemas of what the program writes, from its records.
#pragma once

#include <span>
#include <string>

#include "record/shape.hpp"
#include "report/json_values.hpp"

namespace kinestat {

/// A schema and the name by which it is asked for.
struct NamedSchema {
  std::string name;
  std::string text;  ///< draft 07
};

/// Of every JSON that has a record.
std::span<const NamedSchema> record_schemas();

/// The record of a report by the keys that it has; that of an analysis where none fits.
const RecordShape& record_of(const Json& report);

}  // namespace kinestat
