// Valid mechanism files with something changed, as a tree and not as bytes.
#pragma once

#include <string>

#include "fuzz/choices.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat::fuzz {

/// Changes one thing: a number, a unit, a word, a key, the order of a list, which of two values
/// stands where. Where the file has nothing of the kind chosen it stays as it is.
void change(YamlNode& root, Choices& choices);

/// The tree as a file, with a line for each key of the root.
std::string written(const YamlNode& root);

/// A number of the mechanism, multiplied by a new parameter "swept" of value 1, and a section
/// `sweep` of that one state. False, and the tree as it was, where there is no number.
bool add_sweep(YamlNode& root, Choices& choices);

}  // namespace kinestat::fuzz
