// A section of a mechanism file from a text that is the section alone.
#pragma once

#include <string>

#include "forms/mapping.hpp"
#include "support/read_text.hpp"

namespace kinestat {

/// What the form makes of the text; `what` names the section in messages: "'motion'".
template <class T>
auto read_form(const Form<T>& form,
               const std::string& what,
               const std::string& text,
               Space space = Space::planar) {
  return read_text(text, [&](const YamlNode& node, Diagnostics& found) {
    return form.read({.node = node,
                      .what = what,
                      .where = node.where,
                      .place = node.where,
                      .space = space,
                      .found = found});
  });
}

template <class T>
auto read_section(const Mapping<T>& mapping,
                  const std::string& what,
                  const std::string& text,
                  Space space = Space::planar) {
  return read_form(mapping.form(), what, text, space);
}

}  // namespace kinestat
