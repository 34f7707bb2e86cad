// Single numbers of a record by their place: "power/input".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "expression/file_units.hpp"
#include "record/record.hpp"

namespace kinestat {

/// The places of all results below the keys of objects whose measure the record itself says: none
/// of maps and lists, none of what another part of the report says, no evidence.
std::vector<std::string> number_paths(const RecordShape& record);

/// The unit of the number at that place, empty for a bare one; nullopt where there is none.
std::optional<std::string> unit_at_path(const RecordShape& record,
                                        std::string_view path,
                                        const FileUnits& units);

/// Takes the number at one place, in the units of the file.
class NumberAtPath : public Archive {
 public:
  NumberAtPath(std::string_view path, const FileUnits& units) : path_(path), units_(units) {}

  /// Empty: the solution has none.
  std::optional<double> take() const { return value_; }

  bool begin(const Property& property) override;
  void end(const Property& property) override;

  void element(std::string_view /*name*/, std::string_view /*status*/) override {}

  void begin_object() override {}

  void end_object() override {}

  void begin_map() override { ++outside_; }

  void end_map() override { --outside_; }

  void begin_list() override { ++outside_; }

  void end_list() override { --outside_; }

  void quantity(const std::optional<double>& si, QuantityKind kind) override;
  void number(const std::optional<double>& value, std::string_view unit) override;
  void whole(std::int64_t value) override;

  void text(std::string_view /*value*/) override {}

  void flag(bool /*value*/) override {}

  void null() override {}

 private:
  std::string_view path_;
  const FileUnits& units_;
  std::vector<std::size_t> begins_;  // in the path: of what stands below each open key
  int outside_ = 0;                  // open maps and lists
  std::optional<double> value_;
};

/// Of what a view shows, by its record.
template <class View>
std::optional<double> number_at_path(const Record<View>& record,
                                     const View& view,
                                     std::string_view path,
                                     const FileUnits& units) {
  NumberAtPath archive(path, units);
  record.write(view, archive);
  return archive.take();
}

}  // namespace kinestat
