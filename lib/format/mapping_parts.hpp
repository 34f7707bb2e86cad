// The rarer parts of a declaration; to be included through format/mapping.hpp.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "format/mapping_key.hpp"

namespace kinestat {

template <class T>
FileText Mapping<T>::text(const T& object) const {
  FileText text{.kind = FileText::Kind::mapping, .in_lines = is_in_lines_};
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    if (auto behind = steps_[i].write(object)) {
      text.entries.emplace_back(shape_.keys[i].key, *std::move(behind));
    }
  }
  return text;
}

template <class T>
Form<T> Mapping<T>::form() const {
  return {.shape = shape_,
          .read = [this](const FileValue& value) { return read(value); },
          .write =
              [this](const T& object) {
                FileText written = text(object);
                return shape_.may_be_empty && written.entries.empty() ? FileText() : written;
              }};
}

template <class T>
typename Mapping<T>::Key& Mapping<T>::Key::by(
    Lazy<FormShape> shape,
    std::function<void(const FileValue&, T&)> read,
    std::function<std::optional<FileText>(const T&)> write,
    std::string_view example) {
  key_.shape = std::move(shape);
  if (!example.empty()) {
    key_.examples.push_back(example);
  }
  add({.read = std::move(read), .write = std::move(write)});
  return *this;
}

template <class T>
typename Mapping<T>::Key& Mapping<T>::Key::example(std::string_view text) {
  added().examples.push_back(text);
  return *this;
}

template <class T>
template <class Read>
typename Mapping<T>::Key& Mapping<T>::Key::passed_over(const Form<Read>& form,
                                                       std::string_view example,
                                                       std::optional<Read> written) {
  return by(
      form.shape,
      [read = form.read](const FileValue& value, T&) { (void)read(value); },
      [write = form.write, written](const T&) {
        return written ? std::optional(write(*written)) : std::nullopt;
      },
      example);
}

template <class T>
typename Mapping<T>::Key& Mapping<T>::Key::noted(bool T::*is_there) {
  Step& step = mapping_.steps_.back();
  step.read = [is_there, read = step.read](const FileValue& value, T& object) {
    object.*is_there = true;
    read(value, object);
  };
  step.write = [is_there, write = step.write](const T& object) {
    auto text = write(object);
    return text || !(object.*is_there) ? text
                                       : std::optional(FileText{.kind = FileText::Kind::mapping});
  };
  return *this;
}

template <class T>
template <class Member>
typename Mapping<T>::Key& Mapping<T>::Key::selects(Member T::*member, Member chosen) {
  Step& step = mapping_.steps_.back();
  step.read = [member, chosen, read = step.read](const FileValue& value, T& object) {
    object.*member = chosen;
    read(value, object);
  };
  step.write = [member, chosen, write = step.write](const T& object) {
    return object.*member == chosen ? write(object) : std::nullopt;
  };
  return *this;
}

}  // namespace kinestat
