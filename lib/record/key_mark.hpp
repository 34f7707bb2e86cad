// What is said of a key of a record beside its meaning and its value.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "record/archive.hpp"

namespace kinestat {

/// How the value behind a key is written.
template <class View>
struct KeyStep {
  using Write = std::function<void(const View&, Archive&)>;

  std::function<bool(const View&)> condition;  ///< empty: always
  Write write;
};

/// Marks the key that was added last, until another is added.
template <class View>
class KeyMark {
 public:
  KeyMark(Property& property, KeyStep<View>& step) : property_(property), step_(step) {}

  /// It is left out where the condition does not hold.
  KeyMark& only_if(std::function<bool(const View&)> condition) {
    property_.is_optional = true;
    step_.condition = std::move(condition);
    return *this;
  }

  /// Null where the condition does not hold.
  KeyMark& null_unless(std::function<bool(const View&)> condition) {
    property_.shape.is_nullable = true;
    step_.write = [condition = std::move(condition), value = std::move(step_.write)](
                      const View& view, Archive& to) {
      condition(view) ? value(view, to) : to.null();
    };
    return *this;
  }

  /// The least that its numbers may be; for counts it is 0, unless said otherwise.
  KeyMark& at_least(std::optional<double> least) {
    property_.shape.least = least;
    return *this;
  }

  /// A map has these names only.
  KeyMark& named(std::vector<std::string> names) {
    property_.shape.words = std::move(names);
    return *this;
  }

  /// CSV calls it so; empty: its numbers have no name of their own there.
  KeyMark& in_tables_as(std::string quantity) {
    property_.table_quantity = std::move(quantity);
    return *this;
  }

  KeyMark& in_tables_is(TableRole role) {
    property_.table_role = role;
    return *this;
  }

  KeyMark& not_in_tables() {
    property_.is_in_tables = false;
    return *this;
  }

  /// JSON has the same in another form.
  KeyMark& only_in_tables() {
    property_.is_in_reports = false;
    return *this;
  }

  /// Two reports may differ in it and mean the same.
  KeyMark& not_compared() {
    property_.is_compared = false;
    return *this;
  }

  /// Rates and actions of the object, also below, are for one of the unit that this text names.
  KeyMark& reference_unit() {
    property_.is_reference_unit = true;
    return *this;
  }

  /// The order of the names in the list means something.
  KeyMark& ordered() {
    property_.is_ordered = true;
    return *this;
  }

 private:
  Property& property_;
  KeyStep<View>& step_;
};

}  // namespace kinestat
