// Names that stand in expressions: of parameters and curves.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/value.hpp"
#include "forms/form.hpp"

namespace kinestat {

/// Complains of a name that would be read as something else in an expression; `kind` is what it
/// names: "parameter".
void check_expression_name(const Name& name, std::string_view kind, Diagnostics& found);

/// The same mapping of names to elements, with these checked.
template <class T>
Form<std::vector<T>> named_in_expressions(Form<std::vector<T>> form, std::string kind) {
  form.read = [read = form.read, kind = std::move(kind)](const FileValue& value) {
    auto elements = read(value);
    const int errors_before = value.found.error_count();
    for (const YamlEntry& entry : value.node.entries) {
      check_expression_name({.text = entry.key, .where = entry.key_where}, kind, value.found);
    }
    return value.found.error_count() == errors_before ? elements : std::nullopt;
  };
  return form;
}

}  // namespace kinestat
