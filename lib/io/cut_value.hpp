// Values that commas and brackets of YAML cut or end: max(1, 2) in a list without quotes, 0, 40}.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "core/diagnostic.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// Whether the commas of a list cut an expression in two, so that [max(1, 2), 0] has three items;
/// then an error says so (E0308), and nothing else needs to be said about the list.
bool report_cut_value(const YamlNode& list, Diagnostics& found);

/// Whether a value without quotes ends in a comma, or in a bracket that closes nothing of it, as a
/// text may; then an error says so (E0204), and nothing else needs to be said about the value.
bool report_loose_end(const YamlNode& node, Diagnostics& found);

/// Adds an error for each number with a decimal comma in braces, which make a key of what is behind
/// it: {motor: 6,3 rad/s}, anywhere in the tree.
void report_decimal_commas(const YamlNode& node, Diagnostics& found);

/// What to type if an entry of a mapping is the rest of the one before it: 'free: "max(1, 2)"' for
/// the key '2)' of {free: max(1, 2)}; else empty.
std::string whole_entry(const YamlEntry& before, const YamlEntry& rest);

/// "at: [0, 40]" of {at: 0, 40}, whose entry at `index` is a number for a key: components without
/// their brackets. Empty if it is none.
std::string listed_entry(std::span<const YamlEntry> entries, std::size_t index);

}  // namespace kinestat
