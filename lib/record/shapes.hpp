// The shapes of the usual values, and how vectors are written.
#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "record/archive.hpp"

namespace kinestat {

/// Two vectors: of a twist (angular, linear) or of a wrench (moment, force).
struct Sixfold {
  Vec3 first;
  Vec3 second;
};

/// A vector and what its components measure.
struct MeasuredVector {
  Vec3 value;
  Measure measure;
};

Shape number_shape(const Measure& measure, bool is_nullable);

/// A whole number; never negative, unless said otherwise.
Shape whole_shape(bool is_nullable);
Shape flag_shape(bool is_nullable);

/// Without words: any text.
Shape word_shape(std::vector<std::string> words, bool is_nullable);

Shape vector_shape(const Measure& measure, bool is_nullable);
Shape sixfold_shape(QuantityKind first, QuantityKind second, bool is_nullable);

/// So many of a kind, such as the coordinates of a point of the plane.
Shape tuple_shape(const Shape& item, std::size_t count, bool is_nullable);

Shape object_shape(const RecordShape& record, bool is_nullable);
Shape map_shape(Shape item);
Shape list_shape(Shape item);

/// As one list.
void write_components(std::initializer_list<MeasuredVector> vectors, Archive& to);

/// The words of an enumeration up to its last value, by word_of.
template <class Enum>
std::vector<std::string> words_up_to(Enum last) {
  std::vector<std::string> words;
  for (int i = 0; i <= static_cast<int>(last); ++i) {
    words.emplace_back(word_of(static_cast<Enum>(i)));
  }
  return words;
}

}  // namespace kinestat
