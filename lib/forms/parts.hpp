// The items of lists and the elements of mappings of names while they are read.
#pragma once

#include <cstddef>
#include <string>

#include "forms/form.hpp"

namespace kinestat {

/// An item of a list; `title` names it in messages: "trace point {0}", "station {0} of {1}", with
/// its number from 1 and the owner of the list. Empty: it is called as the list.
FileValue item_of(const FileValue& list, std::size_t index, const std::string& title);

/// An element of a mapping of names, likewise: "load '{0}'", "'{2}' of '{0}'", with
/// its name, the mapping and its key.
FileValue element_of(const FileValue& names, const YamlEntry& entry, const std::string& title);

/// Whether the value is a list of as many items as the shape says; adds an error with the hint if
/// not, by default a sketch of the list.
bool check_items(const FileValue& value, const FormShape& shape, const std::string& hint);

/// Whether the value is a mapping of names, with an element if the shape wants one.
bool check_names(const FileValue& value, const FormShape& shape);

/// How many entries have as many keys as an element needs, so that room is made for no others.
std::size_t count_whole(const YamlNode& names, const FormShape& element);

/// Adds an error if the name of an element is not as the shape wants it.
void check_element_name(const Name& name, const FormShape& shape, Diagnostics& found);

/// A name as the key of an element.
std::string element_key(const Name& name, const FormShape& shape);

}  // namespace kinestat
