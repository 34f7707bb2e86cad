// The forms of single values in a record.
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "record/record_keys.hpp"
#include "record/shapes.hpp"

namespace kinestat {

template <class T>
struct IsOptional : std::false_type {};

template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

/// Whether reading a view so may find no value.
template <class Get, class View>
constexpr bool may_lack() {
  return IsOptional<std::invoke_result_t<Get, const View&>>::value;
}

/// Null where there is no value.
template <class T, class Write>
void write_value(const T& value, Archive& to, const Write& write) {
  if constexpr (IsOptional<T>::value) {
    value ? write(*value) : to.null();
  } else {
    write(value);
  }
}

/// Adds the keys of numbers, words and vectors.
template <class View>
class RecordValues : public RecordKeys<View> {
 public:
  using typename RecordKeys<View>::Mark;
  using Words = std::vector<std::string>;

  template <class Get>
  Mark quantity(std::string key, QuantityKind kind, std::string text, Get get) {
    return this->add(std::move(key),
                     std::move(text),
                     number_shape(kind, may_lack<Get, View>()),
                     [get, kind](const View& view, Archive& to) { to.quantity(get(view), kind); });
  }

  /// Of a kind that the rest of the report tells: `get` answers value and kind.
  template <class Get>
  Mark by_context(std::string key, ByContext measure, std::string text, Get get) {
    return this->add(std::move(key),
                     std::move(text),
                     number_shape(measure, true),
                     [get](const View& view, Archive& to) {
                       const auto [si, kind] = get(view);
                       to.quantity(si, kind);
                     });
  }

  template <class Get>
  Mark number(std::string key, Measure measure, std::string text, Get get) {
    return this->add(std::move(key),
                     std::move(text),
                     number_shape(measure, may_lack<Get, View>()),
                     [get](const View& view, Archive& to) { to.number(get(view), {}); });
  }

  /// Of a number in the unit of the file: `get` answers value and unit.
  template <class Get>
  Mark converted(std::string key, Measure measure, std::string text, Get get) {
    return this->add(std::move(key),
                     std::move(text),
                     number_shape(measure, true),
                     [get](const View& view, Archive& to) {
                       const auto [value, unit] = get(view);
                       to.number(value, unit);
                     });
  }

  template <class Get>
  Mark count(std::string key, std::string text, Get get) {
    return this->add(std::move(key),
                     std::move(text),
                     whole_shape(may_lack<Get, View>()),
                     [get](const View& view, Archive& to) {
                       write_value(get(view), to, [&](auto value) {
                         to.whole(static_cast<std::int64_t>(value));
                       });
                     });
  }

  template <class Get>
  Mark text(std::string key, std::string text, Get get) {
    return word(std::move(key), {}, std::move(text), get);
  }

  /// One of these words.
  template <class Get>
  Mark word(std::string key, Words words, std::string text, Get get) {
    return this->add(std::move(key),
                     std::move(text),
                     word_shape(std::move(words), may_lack<Get, View>()),
                     [get](const View& view, Archive& to) {
                       write_value(get(view), to, [&](std::string_view v) { to.text(v); });
                     });
  }

  template <class Get>
  Mark flag(std::string key, std::string text, Get get) {
    return this->add(std::move(key),
                     std::move(text),
                     flag_shape(may_lack<Get, View>()),
                     [get](const View& view, Archive& to) {
                       write_value(get(view), to, [&](bool v) { to.flag(v); });
                     });
  }

  template <class Get>
  Mark vector(std::string key, Measure measure, std::string text, Get get) {
    return this->add(
        std::move(key),
        std::move(text),
        vector_shape(measure, may_lack<Get, View>()),
        [get, measure](const View& view, Archive& to) {
          write_value(get(view), to, [&](const Vec3& v) { write_components({{v, measure}}, to); });
        });
  }

  /// Three components of one kind, then three of another.
  template <class Get>
  Mark sixfold(
      std::string key, QuantityKind first, QuantityKind second, std::string text, Get get) {
    return this->add(std::move(key),
                     std::move(text),
                     sixfold_shape(first, second, may_lack<Get, View>()),
                     [get, first, second](const View& view, Archive& to) {
                       write_value(get(view), to, [&](const Sixfold& v) {
                         write_components({{v.first, first}, {v.second, second}}, to);
                       });
                     });
  }

 protected:
  using RecordKeys<View>::RecordKeys;
};

}  // namespace kinestat
