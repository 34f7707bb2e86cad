// The forms of single values: names, texts, words, points.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "description/value.hpp"
#include "forms/form.hpp"

namespace kinestat {

/// How the texts look that have a name in the schema: "new_name", "target", "label".
const FormShape& text_shape(std::string_view definition);

/// The name of something that the file declares; `remark` says of what: "an actuator".
Form<Name> name_of(std::string_view remark);

/// Of a body, or the ground.
Form<Name> body_name();

Form<Name> coupling_name();

/// Likewise, where a body is declared; `what` names it in messages: "a body".
Form<Name> new_body_name(std::string what);

/// The same of something else.
Form<Name> new_name(std::string what);

/// Something that no pattern describes.
Form<Name> free_name();

/// An actuator, or coupling.freedom, or coupling.action.
Form<Name> target();

/// An actuator or a load, where power enters or leaves.
Form<Name> power_end();

/// A target, or a word, or a column: NAME/QUANTITY.
Form<Name> column_name();

/// A target, or a word, or a figure of a motion: column.with.dots.figure.
Form<Name> quantity();

/// The label of a case or gear, which is free text.
Form<Name> label();

/// As many components as the space has.
Form<PointDescription> vector_of(const Form<Value>& component,
                                 std::string_view definition,
                                 std::string_view meaning,
                                 SharedList<std::string_view> examples);

/// A point [length].
Form<PointDescription> point();

/// A point in the plane, whatever the space of the file is.
Form<PointDescription> point_in_plane();

/// Free text.
Form<std::string> text();

/// x, -y, z, … or a vector of three numbers, also in the plane.
Form<AxisDescription> turning_axis();

/// The same, of as many components as the space has.
Form<AxisDescription> direction();

/// true or false; what is not there is false.
Form<bool> flag();

FileText text_of(const std::vector<Value>& values);

/// The index of the word.
std::optional<std::size_t> read_word_of(const FileValue& value, const SharedList<Word>& words);

AnyForm any_choice_of(SharedList<Word> words,
                      void (*set)(void* object, std::size_t index),
                      std::size_t (*index_of)(const void* object));

/// One of the words, in the order of the enumeration.
template <class Enum>
Form<Enum> choice_of(SharedList<Word> words) {
  return form_of_a<Enum>(any_choice_of(
      std::move(words),
      [](void* object, std::size_t index) {
        *static_cast<Enum*>(object) = static_cast<Enum>(index);
      },
      [](const void* object) {
        return static_cast<std::size_t>(*static_cast<const Enum*>(object));
      }));
}

}  // namespace kinestat
