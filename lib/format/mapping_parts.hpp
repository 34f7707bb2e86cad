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
bool Mapping<T>::read_into(T& object,
                           const FileValue& value,
                           const SharedList<std::string_view>& known) const {
  const int errors_before = value.found.error_count();
  if (shape_.may_be_empty && value.node.kind == YamlKind::null) {
    return true;
  }
  Fields fields(value.node, value.where, title_of(value), value.found, only_name_of(shape_));
  for (const std::string_view key : known) {
    (void)fields.find(key);
  }
  for (std::size_t i = 0; i < shape_.keys.size(); ++i) {
    if (const auto behind = find_key(shape_, i, fields, value)) {
      steps_[i].read(*behind, object);
    }
  }
  for (const FormKey& own : shape_.beginnings) {
    fields.ignore_prefix(own.key);
  }
  fields.finish();
  if (value.node.kind == YamlKind::mapping) {
    check_rules(shape_, value, errors_before);
  }
  for (const auto& check : checks_) {
    if (value.found.error_count() == errors_before) {
      check(object, value);
    }
  }
  return value.found.error_count() == errors_before;
}

template <class T>
FileText Mapping<T>::text(const T& object) const {
  FileText text{.kind = FileText::Kind::mapping, .in_lines = is_in_lines_};
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    if (auto behind = steps_[i].write(object)) {
      text.entries.emplace_back(shape_.keys[i].key, *std::move(behind));
    }
  }
  leave_out_replaced(shape_, text);
  return text;
}

template <class T>
std::optional<FileText> Mapping<T>::text_if_any(const T& object) const {
  FileText written = text(object);
  return written.entries.empty() ? std::nullopt : std::optional(std::move(written));
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
