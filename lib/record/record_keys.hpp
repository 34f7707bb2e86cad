// The keys of a record, each with how its value is written.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "record/archive.hpp"

namespace kinestat {

/// What is the same for all forms of values; Record adds those.
template <class View>
class RecordKeys : public RecordShape {
 public:
  /// Marks the key that was added last.
  class Mark {
   public:
    explicit Mark(RecordKeys& keys) : keys_(keys) {}

    /// It is left out where the condition does not hold.
    Mark& only_if(std::function<bool(const View&)> condition) {
      property().is_optional = true;
      keys_.steps_.back().condition = std::move(condition);
      return *this;
    }

    /// Null where the condition does not hold.
    Mark& null_unless(std::function<bool(const View&)> condition) {
      property().shape.is_nullable = true;
      Write& write = keys_.steps_.back().write;
      write = [condition = std::move(condition), value = std::move(write)](
                  const View& view, Archive& to) { condition(view) ? value(view, to) : to.null(); };
      return *this;
    }

    /// CSV calls it so; empty: its numbers have no name of their own there.
    Mark& in_tables_as(std::string quantity) {
      property().table_quantity = std::move(quantity);
      return *this;
    }

    Mark& in_tables_is(TableRole role) {
      property().table_role = role;
      return *this;
    }

    Mark& not_in_tables() {
      property().is_in_tables = false;
      return *this;
    }

    /// JSON has the same in another form.
    Mark& only_in_tables() {
      property().is_in_reports = false;
      return *this;
    }

    /// Two reports may differ in it and mean the same.
    Mark& not_compared() {
      property().is_compared = false;
      return *this;
    }

    /// The order of the names in the list means something.
    Mark& ordered() {
      property().is_ordered = true;
      return *this;
    }

   private:
    Property& property() { return keys_.properties.back(); }

    RecordKeys& keys_;
  };

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

  using Write = std::function<void(const View&, Archive&)>;

  Mark add(std::string key, std::string text, Shape shape, Write write) {
    Property property;
    property.table_quantity = key;
    property.key = std::move(key);
    property.meaning = std::move(text);
    property.shape = std::move(shape);
    properties.push_back(std::move(property));
    steps_.push_back({.condition = {}, .write = std::move(write)});
    return Mark(*this);
  }

 private:
  struct Step {
    std::function<bool(const View&)> condition;  // empty: always
    Write write;
  };

  std::vector<Step> steps_;
};

}  // namespace kinestat
