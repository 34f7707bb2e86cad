// Single values of the file: names, numbers, words, points and directions.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/coupling_description.hpp"
#include "io/title.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// Each answers empty iff it added an error. `what` names the value in messages.

/// The words of a scalar with commas between them, "crank, coupler" of "crank coupler", for lists
/// whose commas or brackets were forgotten; empty if it is one word.
std::string with_commas(const YamlNode& node);

/// Any text on one scalar, e.g. a title.
std::optional<std::string> read_text(const YamlNode& node, const Title& what, Diagnostics& found);

/// A reference to something declared elsewhere; its form is not checked.
std::optional<Name> read_reference(const YamlNode& node, const Title& what, Diagnostics& found);

/// Whether a declared name has the form [A-Za-z_][A-Za-z0-9_-]*; adds an error if not.
bool check_name(const Name& name, const Title& what, Diagnostics& found);

/// A number or an expression, kept as typed.
std::optional<Value> read_value(const YamlNode& node, const Title& what, Diagnostics& found);

/// A number without a unit, or an expression of such numbers (595/209).
std::optional<double> read_number(const YamlNode& node, const Title& what, Diagnostics& found);

/// true or false.
std::optional<bool> read_bool(const YamlNode& node, const Title& what, Diagnostics& found);

/// Of a value that is none of the words that may stand there.
void complain_of_word(const YamlNode& node,
                      const Title& what,
                      std::span<const std::string> words,
                      Diagnostics& found);

/// [x, y] in the plane, [x, y, z] in space.
std::optional<PointDescription> read_point(const YamlNode& node,
                                           const Title& what,
                                           Space space,
                                           Diagnostics& found);

/// x, -y, z, … or a vector with as many components as the space has.
std::optional<AxisDescription> read_axis(const YamlNode& node,
                                         const Title& what,
                                         Space space,
                                         Diagnostics& found);

}  // namespace kinestat
