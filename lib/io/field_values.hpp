// The values under the keys of a mapping, read in one step.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/coupling_description.hpp"
#include "io/fields.hpp"

namespace kinestat {

/// Each is empty if the key is absent, or if an error was added. In messages the value is called
/// "'radius' of cable 'rope'".
std::optional<Value> find_value(Fields& fields, std::string_view key, Diagnostics& found);
bool find_bool(Fields& fields, std::string_view key, Diagnostics& found);
std::optional<PointDescription> find_point(Fields& fields,
                                           std::string_view key,
                                           Space space,
                                           Diagnostics& found);
std::optional<std::size_t> find_word(Fields& fields,
                                     std::string_view key,
                                     std::span<const std::string> words,
                                     Diagnostics& found);

/// The same for a key that must be there; a default after an error.
Value require_value(Fields& fields, std::string_view key, Diagnostics& found);
PointDescription require_point(Fields& fields,
                               std::string_view key,
                               Space space,
                               Diagnostics& found);

/// Where a key of a mapping stands; the whole value if it is absent.
SourceRange place_of_key(const YamlNode& mapping, std::string_view key);

}  // namespace kinestat
