// A record as tidy tables of comma-separated values.
#pragma once

#include <string>
#include <vector>

#include "expression/file_units.hpp"
#include "record/record.hpp"
#include "report/report_forms.hpp"

namespace kinestat {

/// The header line that every table begins with.
inline constexpr std::string_view kCsvHeader =
    "mechanism,case,pass,element,quantity,value,unit,status\n";

/// What stands for a number that is null.
enum class MissingNumber { empty_cell, no_row };

/// One row a number: `quantity` is its path below the element, `value` is empty where it is null.
/// `status` is that of the table, unless the element has one of its own. The names of the map or
/// the numbers of the list of a key that is an element are elements themselves, "dyads/0", where
/// each has quantities of its own; names below these are part of the quantity: no two rows have one
/// name.
class TableArchive : public Archive {
 public:
  /// `mechanism` stands in the first cell of every row. What is below the key `parameters` has its
  /// name in a column `parameter`, which the tables have then.
  TableArchive(std::string mechanism,
               const FileUnits& units,
               MissingNumber missing = MissingNumber::empty_cell,
               std::string_view parameters = {});

  /// In the order in which they began. One that every report of the record has is there without
  /// rows, too.
  std::vector<NamedTable> take() { return std::move(tables_); }

  bool begin(const Property& property) override;
  void end(const Property& property) override;
  void element(std::string_view name, std::string_view status) override;
  void begin_object() override;
  void end_object() override;
  void begin_map() override;
  void end_map() override;
  void begin_list() override;
  void end_list() override;
  void quantity(const std::optional<double>& si, QuantityKind kind) override;
  void number(const std::optional<double>& value, std::string_view unit) override;
  void whole(std::int64_t value) override;
  void text(std::string_view value) override;
  void flag(bool value) override;
  void null() override;

 private:
  // A value that is open.
  struct Open {
    enum class Kind { object, map, cases, list } kind = Kind::object;
    int next = 0;             // of a list: the number of its next item
    bool is_item = false;     // it is itself an item of a list
    std::string element;      // of what contains it
    std::string own_status;   // likewise
    std::string outer_case;   // of cases: the one that contains them
    std::string elements_of;  // the key whose items or names are elements: "dyads" of "dyads/0"
    bool names_path = false;  // the name of its element ends the path
    std::string reference;    // the unit for one of which its rates and actions are
    const Shape* shape = nullptr;  // its own; null where the record says none
    std::size_t properties = 0;    // that were open before
  };

  void open(Open::Kind kind);
  const Shape* next_shape() const;
  bool has_parameters(const Property& property) const;
  void close();
  bool begin_item();
  void end_item(bool is_item);
  void word(const std::string& ending, const char* value);
  void row(const std::string& value, std::string_view unit);
  std::string unit_of(QuantityKind kind) const;
  NamedTable& table(const std::string& pass);
  void begin_tables(const Property& property);

  std::string mechanism_;
  const FileUnits& units_;
  MissingNumber missing_ = MissingNumber::empty_cell;
  std::vector<NamedTable> tables_;
  std::string pass_;  // of the table that is open; empty: none
  std::string case_;
  std::string status_;  // of the table
  std::string element_;
  std::vector<bool> element_keys_;           // a key that is an element: whether it is in the path
  std::string own_status_;                   // of the element, if it is not that of the table
  std::vector<std::string> path_;            // of the quantity
  std::vector<const Property*> properties_;  // that are open
  std::vector<Open> open_;
  std::string_view parameters_;  // the key whose map is one of parameters
  std::string parameter_;
  bool names_parameters_ = false;  // the map that is open
  bool names_cases_ = false;       // the next map or list
  bool names_elements_ = false;    // likewise
  bool reads_status_ = false;      // the next text
};

/// What a view shows, by its record.
template <class View>
std::vector<NamedTable> tables_of(const Record<View>& record,
                                  const View& view,
                                  const std::string& mechanism,
                                  const FileUnits& units,
                                  MissingNumber missing = MissingNumber::empty_cell,
                                  std::string_view parameters = {}) {
  TableArchive archive(mechanism, units, missing, parameters);
  record.write(view, archive);
  return archive.take();
}

}  // namespace kinestat
