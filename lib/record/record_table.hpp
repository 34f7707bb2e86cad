// The keys of a report for pages of help.
#pragma once

#include <functional>
#include <string>

#include "record/shape.hpp"

namespace kinestat {

/// Each key with what stands behind it and what that means; below an object its keys, indented. The
/// keys of a record that stands in several places are told once. `page_of` answers where the keys
/// of a record are told instead, or nothing.
std::string record_table(const RecordShape& record,
                         const std::function<std::string(const RecordShape&)>& page_of);

/// The record of the objects behind a key, in whatever lists and maps they stand; null: none.
const RecordShape* record_behind(const Shape& shape);

}  // namespace kinestat
