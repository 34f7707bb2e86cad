// Values that may be written in several ways: as a list, as a mapping, or as a single value.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "format/form.hpp"

namespace kinestat {

/// The index of the form that a value of this shape in the file has; else the first.
std::size_t form_for(const YamlNode& node, const SharedList<FormShape>& shapes);

/// A form for another type: `to` makes it of what is read, `from` answers what is written.
template <class T, class Given, class To, class From>
Form<T> converted(const Form<Given>& form, To to, From from) {
  return {.shape = form.shape,
          .read = [form, to](const FileValue& value) -> std::optional<T> {
            auto given = form.read(value);
            return given ? std::optional<T>(to(*std::move(given))) : std::nullopt;
          },
          .write = [form, from](const T& value) { return form.write(from(value)); }};
}

/// One of the forms; `choose` says which of them a value is written in.
template <class T>
Form<T> by_shape(std::vector<Form<T>> forms, std::function<std::size_t(const T&)> choose) {
  FormShape shape{.kind = FormKind::by_shape};
  for (const Form<T>& form : forms) {
    shape.items.push_back(form.shape);
  }
  return {.shape = shape,
          .read =
              [forms, shapes = shape.items](const FileValue& value) {
                return forms[form_for(value.node, shapes)].read(value);
              },
          .write = [forms, choose](const T& value) { return forms[choose(value)].write(value); }};
}

}  // namespace kinestat
