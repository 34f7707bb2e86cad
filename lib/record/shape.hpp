// What a report may hold: its keys, what stands behind each, and what its numbers measure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "expression/quantity.hpp"

namespace kinestat {

/// What a number without a unit is.
enum class Bare {
  count,       ///< a whole number of things
  number,      ///< any other
  ratio,       ///< of two quantities of a kind
  efficiency,  ///< share of a power
  direction    ///< component of a unit vector
};

/// Where another part of the report says what a number measures.
enum class ByContext {
  rate,          ///< velocity or angular velocity: the name of the freedom
  action,        ///< force or moment: the name of the action or the actuator
  rate_ratio,    ///< of input and output: the unit beside it, bare where both are alike
  action_ratio,  ///< likewise
  coefficient,   ///< of an action or a rate, per parameter: both names
  beside,        ///< the key "unit" of the same object
  drive,         ///< the unit of the drive
  column,        ///< the unit of the column
  relative,      ///< to other numbers, as the entries of a matrix
  coordinate,    ///< angle or length: the kind of the input
  per_length     ///< by the unit of length, whatever else; angles in radians
};

/// The word in schemas, and of those without a unit also in tolerances of `compare`.
std::string_view word_of(Bare measure);
std::string_view word_of(ByContext measure);

using Measure = std::variant<QuantityKind, Bare, ByContext>;

struct RecordShape;

/// What stands behind a key.
struct Shape {
  enum class Form {
    number,
    whole,   ///< a whole number
    text,    ///< any
    word,    ///< one of `words`
    flag,    ///< true or false
    object,  ///< with the keys of `record`
    map,     ///< from names to `items.front()`
    list,    ///< of `items.front()`, any number
    tuple,   ///< of `items`, one each
    cell     ///< number or text
  };

  Form form = Form::text;
  Measure measure = Bare::number;  ///< of a number
  bool is_nullable = false;        ///< null where there is no value
  bool may_be_by_name = false;     ///< or several of them by name
  std::optional<double> least;     ///< a number is never below
  std::vector<std::string> words;  ///< empty also where any word may stand; of a map: its names
  const RecordShape* record = nullptr;
  std::vector<Shape> items;
};

/// What a key is to tables of comma-separated values.
enum class TableRole {
  quantity,        ///< part of the name of the quantity
  element,         ///< the element to which all below it belongs; below another, part of the name
  word,            ///< a word ends the name of a 1; yes is 1 and no is 0
  cases,           ///< a map or a list whose names are those of the cases; in a case: "0.1"
  table,           ///< all below it has a table of its own
  table_of_cases,  ///< both
  status           ///< that of the table
};

/// One key of an object.
struct Property {
  std::string key;
  std::string meaning;  ///< a sentence
  Shape shape;
  bool is_optional = false;   ///< the key is left out where there is nothing to say
  bool is_compared = true;    ///< whether it counts where two reports are compared
  bool is_ordered = false;    ///< of a list of names: whether their order means something
  bool is_in_reports = true;  ///< whether JSON has it
  bool is_in_tables = true;   ///< whether its numbers have rows in CSV
  /// Its text is a unit, and rates and actions of the object, also below, are for one of it.
  bool is_reference_unit = false;
  TableRole table_role = TableRole::quantity;
  std::string table_quantity;  ///< what CSV calls it: the key, unless said otherwise
};

/// The keys of an object, in their order.
struct RecordShape {
  std::string meaning;  ///< a sentence
  std::vector<Property> properties;
};

}  // namespace kinestat
