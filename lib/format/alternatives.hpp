// Values that may be written in several ways: as a list, as a mapping, or as a single value.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "format/form.hpp"

namespace kinestat {

/// The index of the form that a value of this shape in the file has; else the first.
std::size_t form_for(const YamlNode& node, const SharedList<Lazy<FormShape>>& shapes);

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

/// The same, called otherwise in messages: {0} is the mapping that has the key, {1} the key.
template <class T>
Form<T> called(Form<T> form, std::string title) {
  form.read = [read = form.read, title = std::move(title)](const FileValue& value) {
    FileValue renamed = value;
    renamed.what =
        fmt::format(fmt::runtime(title), value.owner, value.key != nullptr ? value.key->key : "");
    return read(renamed);
  };
  return form;
}

/// The same, with a complaint of its own of a value that `fits` says is none; {} is the value.
template <class T, class Fits>
Form<T> only_if(Form<T> form, Fits fits, std::string message, std::string hint) {
  form.read = [=, read = form.read](const FileValue& value) -> std::optional<T> {
    if (fits(value.node)) {
      return read(value);
    }
    value.found.error(
        "E0304", value.node.where, fmt::format(fmt::runtime(message), value.what), hint);
    return std::nullopt;
  };
  return form;
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
