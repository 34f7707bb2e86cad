// What a solution reports, told once: every form of it follows from its record.
#pragma once

#include "record/each.hpp"
#include "record/record_values.hpp"

namespace kinestat {

/// The keys of what `View` shows of a solution. Each call adds one: key, meaning, and how it is
/// read. Values are in SI; an empty std::optional is null.
template <class View>
class Record : public RecordValues<View> {
 public:
  using typename RecordKeys<View>::Mark;

  /// `fill(Record&)` adds the keys.
  template <class Fill>
  Record(std::string what, Fill fill) : RecordValues<View>(std::move(what)) {
    fill(*this);
  }

  /// An object with a record of its own.
  template <class Part, class Get>
  Mark part(std::string key, const Record<Part>& record, Get get) {
    return part(std::move(key), record, record.meaning, std::move(get));
  }

  /// Likewise, of several of a kind: the text says which.
  template <class Part, class Get>
  Mark part(std::string key, const Record<Part>& record, std::string text, Get get) {
    return this->add(std::move(key),
                     std::move(text),
                     object_shape(record, may_lack<Get, View>()),
                     [get, &record](const View& view, Archive& to) {
                       write_value(get(view), to, [&](const Part& v) { record.write(v, to); });
                     });
  }

  /// Objects by name; `emit(view, Each<Item>)`.
  template <class Item, class Emit>
  Mark map(std::string key, const Record<Item>& record, std::string text, Emit emit) {
    return this->add(std::move(key),
                     std::move(text),
                     map_shape(object_shape(record, false)),
                     [emit, &record](const View& view, Archive& to) {
                       to.begin_map();
                       emit(view, Each<Item>(to, record));
                       to.end_map();
                     });
  }

  /// Numbers by name; `emit(view, EachNumber)`.
  template <class Emit>
  Mark numbers(std::string key, Measure measure, std::string text, Emit emit) {
    return this->add(std::move(key),
                     std::move(text),
                     map_shape(number_shape(measure, true)),
                     [emit](const View& view, Archive& to) {
                       to.begin_map();
                       emit(view, EachNumber(to));
                       to.end_map();
                     });
  }

  /// Objects in a list; `emit(view, Each<Item>)`.
  template <class Item, class Emit>
  Mark list(std::string key, const Record<Item>& record, std::string text, Emit emit) {
    return this->add(std::move(key),
                     std::move(text),
                     list_shape(object_shape(record, false)),
                     [emit, &record](const View& view, Archive& to) {
                       to.begin_list();
                       emit(view, Each<Item>(to, record));
                       to.end_list();
                     });
  }

  /// A list of names; `emit(view, EachName)`.
  template <class Emit>
  Mark names(std::string key, std::string text, Emit emit) {
    return this->add(std::move(key),
                     std::move(text),
                     list_shape(word_shape({}, false)),
                     [emit](const View& view, Archive& to) {
                       to.begin_list();
                       emit(view, EachName(to));
                       to.end_list();
                     });
  }

  /// What has no form above; `emit(view, Archive)`.
  template <class Emit>
  Mark custom(std::string key, Shape shape, std::string text, Emit emit) {
    return this->add(std::move(key), std::move(text), std::move(shape), std::move(emit));
  }
};

}  // namespace kinestat
