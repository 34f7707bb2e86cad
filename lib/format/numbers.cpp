#include "format/numbers.hpp"

#include <utility>

#include "io/value_reader.hpp"

namespace kinestat {

Form<Value> number_form(std::string definition,
                        std::string meaning,
                        std::vector<std::string> examples,
                        NumberRange range) {
  return {.shape = {.kind = FormKind::number,
                    .definition = std::move(definition),
                    .meaning = std::move(meaning),
                    .examples = std::move(examples),
                    .range = range},
          .read = [](const FileValue& v) { return read_value(v.node, v.what, v.found); },
          .write = [](const Value& value) { return value.expression.text(); }};
}

Form<Value> length() {
  return number_form("length",
                     "A length: a bare number counts in the file's unit of length (default m), or "
                     "write the unit.",
                     {"7", "25 mm", "(N1 + N5)/2*module"});
}

Form<Value> drawn_position() {
  return number_form("drawn_position",
                     "Position of a freedom, measured from the drawn position: an angle or a "
                     "length, a bare number in the file's unit.",
                     {"0 deg", "360 deg", "-20 mm"});
}

Form<Value> step_count() {
  return number_form("steps",
                     "A whole number from 1 to 1000000.",
                     {"360"},
                     {.least = 1, .most = 1000000, .is_whole = true});
}

}  // namespace kinestat
