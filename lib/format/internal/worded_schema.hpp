// Parts of the schemas of mappings that a word chooses.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "format/internal/json.hpp"
#include "forms/form_shape.hpp"

namespace kinestat {

/// That the word stands behind the key.
Json has_word(std::string_view key, std::string_view word);

/// The required keys that all the schemas have.
Json needed_by_all(const std::vector<Json>& mappings);

/// Puts references to the definition in place of what several of the schemas say of a key; answers
/// the definition. `shape` names the mappings by its words.
Json share_keys(const FormShape& shape, std::vector<Json>& mappings, const std::string& definition);

/// Leaves the keys that all need, which are said elsewhere, without a condition.
void settle(Json& mapping, const Json& needed);

/// Counts of components of all mappings together: those of keys that differ from mapping to mapping
/// under their word. `components` are those of the mappings, each null or with properties.
Json worded_counts(const FormShape& shape, const std::vector<Json>& components);

}  // namespace kinestat
