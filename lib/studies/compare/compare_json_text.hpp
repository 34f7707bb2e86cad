// JSON from bytes that may be anything.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "core/source.hpp"
#include "report/json_values.hpp"

namespace kinestat {

/// The JSON value of a text, read strictly: no NaN, no number beyond a double, no key twice, at
/// most 64 levels. Complains with E0903; empty iff an error was added.
std::optional<Json> read_json(const SourceFile& source, Diagnostics& found);

}  // namespace kinestat
