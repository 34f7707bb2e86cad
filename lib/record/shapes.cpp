#include "record/shapes.hpp"

namespace kinestat {

std::string_view word_of(Bare measure) {
  switch (measure) {
    case Bare::count:
      return "count";
    case Bare::number:
      return "number";
    case Bare::ratio:
      return "ratio";
    case Bare::efficiency:
      return "efficiency";
    case Bare::direction:
      return "direction";
  }
  return "";
}

std::string_view word_of(ByContext measure) {
  switch (measure) {
    case ByContext::rate:
      return "velocity or angular velocity, as the freedom says";
    case ByContext::action:
      return "force or moment, as the action says";
    case ByContext::rate_ratio:
      return "ratio of the rates of input and output";
    case ByContext::action_ratio:
      return "ratio of the actions of input and output";
    case ByContext::coefficient:
      return "rate or action per parameter";
    case ByContext::beside:
      return "in the unit beside it";
    case ByContext::drive:
      return "in the unit of the drive";
    case ByContext::column:
      return "in the unit of the column";
    case ByContext::coordinate:
      return "angle or length, as the input says";
    case ByContext::per_length:
      return "per length";
    case ByContext::relative:
      return "relative to other numbers";
  }
  return "";
}

Shape number_shape(const Measure& measure, bool is_nullable) {
  Shape shape;
  shape.form = Shape::Form::number;
  shape.measure = measure;
  shape.is_nullable = is_nullable;
  return shape;
}

Shape whole_shape(bool is_nullable) {
  Shape shape = number_shape(Bare::count, is_nullable);
  shape.form = Shape::Form::whole;
  shape.least = 0;
  return shape;
}

Shape flag_shape(bool is_nullable) {
  Shape shape;
  shape.form = Shape::Form::flag;
  shape.is_nullable = is_nullable;
  return shape;
}

Shape word_shape(std::vector<std::string> words, bool is_nullable) {
  Shape shape;
  shape.form = words.empty() ? Shape::Form::text : Shape::Form::word;
  shape.words = std::move(words);
  shape.is_nullable = is_nullable;
  return shape;
}

Shape vector_shape(const Measure& measure, bool is_nullable) {
  return tuple_shape(number_shape(measure, false), 3, is_nullable);
}

Shape sixfold_shape(QuantityKind first, QuantityKind second, bool is_nullable) {
  Shape shape = vector_shape(first, is_nullable);
  shape.items.insert(shape.items.end(), 3, number_shape(second, false));
  return shape;
}

Shape tuple_shape(const Shape& item, std::size_t count, bool is_nullable) {
  Shape shape;
  shape.form = Shape::Form::tuple;
  shape.is_nullable = is_nullable;
  shape.items.assign(count, item);
  return shape;
}

Shape object_shape(const RecordShape& record, bool is_nullable) {
  Shape shape;
  shape.form = Shape::Form::object;
  shape.record = &record;
  shape.is_nullable = is_nullable;
  return shape;
}

Shape map_shape(Shape item) {
  Shape shape;
  shape.form = Shape::Form::map;
  shape.items.push_back(std::move(item));
  return shape;
}

Shape list_shape(Shape item) {
  Shape shape = map_shape(std::move(item));
  shape.form = Shape::Form::list;
  return shape;
}

void write_components(std::initializer_list<MeasuredVector> vectors, Archive& to) {
  to.begin_list();
  for (const MeasuredVector& vector : vectors) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      if (const auto* kind = std::get_if<QuantityKind>(&vector.measure)) {
        to.quantity(vector.value[i], *kind);
      } else {
        to.number(vector.value[i], {});
      }
    }
  }
  to.end_list();
}

}  // namespace kinestat
