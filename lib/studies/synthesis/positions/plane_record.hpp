// How records tell what lies in the plane: points, lists of them, ranges, circles.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "expression/file_units.hpp"
#include "record/record.hpp"
#include "studies/synthesis/positions/special_frame.hpp"

namespace kinestat {

/// x and y.
Shape point_shape(const Measure& measure, bool is_nullable);
void write_point(const Point& point, const Measure& measure, Archive& to);

/// A curvature, or one by a parameter without unit, with its unit in the file.
std::pair<std::optional<double>, std::string> per_length(const std::optional<double>& si,
                                                         const FileUnits& units);

const Record<Circle>& circle_record();

/// The words of an enumeration that begins with `none`, up to its last value.
template <class Enum>
std::vector<std::string> words_after_none(Enum last) {
  std::vector<std::string> words = words_up_to(last);
  words.erase(words.begin());
  return words;
}

/// Null for `none`.
template <class Enum>
std::optional<std::string_view> word_unless_none(Enum value) {
  return value == Enum::none ? std::nullopt : std::optional(word_of(value));
}

/// `get` answers a point [length], or perhaps none.
template <class View, class Get>
auto add_point(
    Record<View>& keys, std::string key, const Measure& measure, std::string text, Get get) {
  return keys.custom(std::move(key),
                     point_shape(measure, may_lack<Get, View>()),
                     std::move(text),
                     [get, measure](const View& view, Archive& to) {
                       write_value(
                           get(view), to, [&](const Point& p) { write_point(p, measure, to); });
                     });
}

/// `get` answers points [length], of which some may be missing.
template <class View, class Get>
auto add_points(Record<View>& keys, std::string key, std::string text, Get get) {
  using Item = typename std::decay_t<std::invoke_result_t<Get, const View&>>::value_type;
  return keys.custom(
      std::move(key),
      list_shape(point_shape(QuantityKind::length, IsOptional<Item>::value)),
      std::move(text),
      [get](const View& view, Archive& to) {
        to.begin_list();
        for (const Item& item : get(view)) {
          write_value(item, to, [&](const Point& p) { write_point(p, QuantityKind::length, to); });
        }
        to.end_list();
      });
}

/// `get` answers whole numbers.
template <class View, class Get>
auto add_counts(Record<View>& keys, std::string key, std::string text, Get get) {
  return keys.custom(std::move(key),
                     list_shape(whole_shape(false)),
                     std::move(text),
                     [get](const View& view, Archive& to) {
                       to.begin_list();
                       for (const auto value : get(view)) {
                         to.whole(static_cast<std::int64_t>(value));
                       }
                       to.end_list();
                     });
}

}  // namespace kinestat
