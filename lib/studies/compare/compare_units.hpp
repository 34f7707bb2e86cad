// Which unit a number of a JSON report has.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "expression/file_units.hpp"
#include "record/shape.hpp"
#include "report/json_values.hpp"
#include "studies/compare/compare_values.hpp"

namespace kinestat {

/// The names of the elements and the numbers of the items on the way to a value.
using Labels = std::vector<std::string_view>;

/// What a report says about its units: mechanism.units, the units of the parameters, of drives and
/// columns of a motion, the freedoms of its couplings, which tell rotations from translations, and
/// the dyads of its linkages, which do so for their drives. A report has few units and many values:
/// each unit is made once, and lives as long as this.
class ReportUnits {
 public:
  /// Reads them; empty, with what is wrong, if a unit is none.
  static std::optional<ReportUnits> read(const Json& report, std::string& problem);

  /// The unit of a number by what the record of reports says of it. One that the report does not
  /// tell (the entries of matrices, what this program does not know) assumes all units of the
  /// report.
  const ValueUnit& unit_of(const Shape* shape, const Labels& labels) const;

  /// The unit that the object names; unknown if that is none. Of the number behind a key that is
  /// "unit", unless it has a key of its own, as "speed_after" has "speed_unit".
  const ValueUnit& beside(const Json& object, std::string_view key = "") const;

  /// Likewise of a rate or an action that is for one of the unit which a text names.
  const ValueUnit& per(const Json& reference, const Shape& shape, const Labels& labels) const;

 private:
  using Units = std::map<std::string, ValueUnit, std::less<>>;

  // By what is above and what is below.
  using Quotients = std::map<std::pair<const ValueUnit*, const ValueUnit*>, ValueUnit>;

  struct RatioUnits {
    Units of_cases;
    Units of_outputs;  // of a shift table; a single one without a name
  };

  std::optional<std::string> read_file_units(const Json& report);
  std::optional<std::string> read_parameters(const Json& report);
  void read_couplings(const Json& report);
  void read_ratios(const Json& report);
  void read_motion(const Json& report);
  void read_synthesis(const Json& report);

  const ValueUnit& of(QuantityKind kind) const { return kinds_[static_cast<std::size_t>(kind)]; }

  const ValueUnit& named(const Json& text) const;
  const ValueUnit& rate(std::string_view freedom) const;
  const ValueUnit& action(std::string_view name) const;
  const ValueUnit& ratio(const RatioUnits& units, const Labels& labels) const;
  const ValueUnit& magnitude(std::string_view name) const;
  const ValueUnit& parameter(std::string_view name) const;
  const ValueUnit& coordinate(const Labels& labels) const;
  const ValueUnit& drive(std::string_view label) const;
  const ValueUnit& column(std::string_view name) const;
  const ValueUnit& coefficient(std::string_view magnitude, std::string_view parameter) const;

  FileUnits units_;
  std::array<ValueUnit, kQuantityKindCount> kinds_;
  ValueUnit unknown_;
  ValueUnit per_length_;
  ValueUnit ratio_;  // where the report names none
  RatioUnits rate_ratios_;
  RatioUnits action_ratios_;
  Units parameters_;
  std::vector<std::pair<std::string, ValueUnit>> drives_;  // by name
  Units columns_;
  std::set<std::string> sliding_drives_;  // of linkages: "task/linkage/drive", by number
  std::map<std::string, char, std::less<>> actuators_;  // 'w' turn, 'v' slide, '?' not told
  mutable Units named_;                                 // by their texts
  mutable Quotients references_;
  mutable Quotients coefficients_;
};

}  // namespace kinestat
