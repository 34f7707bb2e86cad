// The keys of a record, each with how its value is written.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "record/key_mark.hpp"

namespace kinestat {

/// What is the same for all forms of values; Record adds those.
template <class View>
class RecordKeys : public RecordShape {
 public:
  using Mark = KeyMark<View>;

  // Records that contain it hold its address.
  RecordKeys(const RecordKeys&) = delete;
  RecordKeys& operator=(const RecordKeys&) = delete;

  /// Writes an object.
  void write(const View& view, Archive& to) const {
    to.begin_object();
    write_keys(view, to);
    to.end_object();
  }

  /// Adds all keys of another record; `get` answers what it shows.
  template <class Part, class Get>
  void include(const RecordKeys<Part>& other, Get get) {
    for (std::size_t i = 0; i < other.properties.size(); ++i) {
      this->properties.push_back(other.properties[i]);
      steps_.push_back(
          {.condition = [&other, get, i](const View& v) { return other.has(i, get(v)); },
           .write = [&other, get, i](const View& v, Archive& to) { other.write(i, get(v), to); }});
    }
  }

  /// Writes the keys into the object that is open.
  void write_keys(const View& view, Archive& to) const {
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      if (has(i, view) && to.begin(properties[i])) {
        write(i, view, to);
        to.end(properties[i]);
      }
    }
  }

  /// Whether there is something to say behind the key of that index.
  bool has(std::size_t key, const View& view) const {
    return !steps_[key].condition || steps_[key].condition(view);
  }

  /// Writes the value behind the key of that index.
  void write(std::size_t key, const View& view, Archive& to) const { steps_[key].write(view, to); }

 protected:
  explicit RecordKeys(std::string what) { meaning = std::move(what); }

  Mark add(std::string key, std::string text, Shape shape, typename KeyStep<View>::Write write) {
    Property property;
    property.table_quantity = key;
    property.key = std::move(key);
    property.meaning = std::move(text);
    property.shape = std::move(shape);
    properties.push_back(std::move(property));
    steps_.push_back({.condition = {}, .write = std::move(write)});
    return Mark(properties.back(), steps_.back());
  }

 private:
  std::vector<KeyStep<View>> steps_;
};

}  // namespace kinestat
