// Values that may be written in several ways: as a list, as a mapping, or as a single value.
#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "forms/form.hpp"

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

AnyRead any_called(const AnyRead& read, std::string title);

/// The same, called otherwise in messages: {0} is the mapping that has the key, {1} the key.
template <class T>
Form<T> called(Form<T> form, std::string title) {
  form.read = any_called(form.read.any(), std::move(title));
  return form;
}

AnyRead any_only_if(const AnyRead& read,
                    std::function<bool(const YamlNode&)> fits,
                    std::string message,
                    std::string hint);

/// The same, with a complaint of its own of a value that `fits` says is none; {} is the value.
template <class T>
Form<T> only_if(Form<T> form,
                std::function<bool(const YamlNode&)> fits,
                std::string message,
                std::string hint) {
  form.read = any_only_if(form.read.any(), std::move(fits), std::move(message), std::move(hint));
  return form;
}

AnyForm any_by_shape(std::vector<AnyForm> forms, AnyChoice choose);

/// One of the forms; `choose` says which of them a value is written in.
template <class T, std::invocable<const T&> Choose>
Form<T> by_shape(std::initializer_list<Form<T>> forms, Choose choose) {
  std::vector<AnyForm> any;
  for (const Form<T>& form : forms) {
    any.push_back(any_of(form));
  }
  return form_of_a<T>(any_by_shape(std::move(any), any_choice<T>(std::move(choose))));
}

}  // namespace kinestat
