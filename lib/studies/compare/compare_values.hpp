// A report as a list of values, each at its place, by which two reports are compared.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "expression/units.hpp"
#include "studies/compare/place_index.hpp"

namespace kinestat {

/// What a number counts, and in what. The kind is what tolerances name: "moment",
/// "angular_velocity" and so on, or one of "ratio", "efficiency", "direction", "count" and
/// "number".
struct ValueUnit {
  std::string kind = "number";
  std::string text;  ///< "N*mm"; empty for a bare number
  UnitScale scale;
  Dimension dimension;
  /// Where the report does not tell the unit: all units of the report. Such a number can only be
  /// compared with one of a report that has the same units.
  std::string assumes;

  friend bool operator==(const ValueUnit&, const ValueUnit&) = default;
};

/// The kinds that a number may have.
const std::vector<std::string>& value_kinds();

/// Whether numbers of that kind may have the dimension.
bool may_measure(const Dimension& dimension, std::string_view kind);

/// The unit of counts, which must be equal whatever the tolerances are.
ValueUnit count_unit();

/// A unit that is written in a report, "N*mm", "rad/s per mm/s", "1 per mm" or empty; with the
/// error of a text that is no unit.
std::variant<ValueUnit, ExpressionError> read_unit(std::string_view text);

/// That of a ratio of two kinds: "rad/s per mm/s".
ValueUnit unit_per(const ValueUnit& above, const ValueUnit& below);

/// A number without a unit.
ValueUnit bare_unit(std::string kind);

enum class ValueType {
  number,
  text,
  null,  ///< there is no value: null in JSON, an empty cell in a table
  empty  ///< a list or a mapping with nothing in it
};

struct ReportValue {
  std::string place;
  ValueType type = ValueType::null;
  double number = 0.0;
  std::size_t unit = 0;  ///< of a number: index into ReportValues::units
  std::string text;
};

enum class ReportForm { json, csv };

/// A value as a report keeps it: what it says stands in the report, and lives as long.
struct KeptValue {
  std::string_view parent;  ///< the place of what it is in
  std::string_view key;     ///< below it, escaped as in places
  std::string_view text;
  double number = 0.0;
  std::uint32_t unit = 0;
  ValueType type = ValueType::null;

  std::string place() const;
  ReportValue value() const;
};

/// The values in the order of the report; no two have one place. Large reports have millions: a
/// value costs its key and little more, neighbours share the place above them, and places are
/// indexed only where one is looked for.
class ReportValues {
 public:
  explicit ReportValues(ReportForm form) : form_(form) {}

  ReportValues(const ReportValues&) = delete;  // values point into it
  ReportValues& operator=(const ReportValues&) = delete;
  ReportValues(ReportValues&&) = default;
  ReportValues& operator=(ReportValues&&) = default;
  ~ReportValues() = default;

  ReportForm form() const { return form_; }

  const std::deque<KeptValue>& items() const { return items_; }

  const ValueUnit& unit_of(const KeptValue& value) const { return units_[value.unit]; }

  /// The value at a place, or null.
  const KeptValue* find(std::string_view place) const;

  /// Which of the items has a place.
  std::optional<std::size_t> position_of(std::string_view parent, std::string_view key) const;

  /// Adds a value; false if there is one at this place, and then adds nothing.
  bool add(std::string_view place, ValueType type, std::string_view text = {});
  bool add_number(std::string_view place, double number, const ValueUnit& unit);

  /// The same of values whose places are known to differ.
  void append(std::string_view place, ValueType type, std::string_view text = {});
  void append_number(std::string_view place, double number, std::uint32_t unit);

  /// The number of a unit in this report.
  std::uint32_t index_of(const ValueUnit& unit);

 private:
  void keep(std::string_view place, KeptValue value);
  std::string_view kept(std::string_view text);

  ReportForm form_;
  std::deque<KeptValue> items_;
  std::deque<std::string> blocks_;  // of places and texts; a block never grows beyond its capacity
  std::vector<ValueUnit> units_;
  mutable PlaceIndex index_;  // of the items, from the first on
};

}  // namespace kinestat
