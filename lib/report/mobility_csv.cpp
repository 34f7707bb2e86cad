#include "report/mobility_csv.hpp"

#include <array>
#include <map>

#include "core/utf8.hpp"
#include "report/table_archive.hpp"
#include "report/csv.hpp"
#include "report/numbers.hpp"

namespace kinestat {

namespace {

class MobilityCsv {
 public:
  explicit MobilityCsv(const MobilityAnalysis& analysis) : analysis_(analysis) {
    const Topology& topology = analysis.in_space.topology;
    for (int a = 0; a < topology.action_count(); ++a) {
      add_unit(topology.action_name(a),
               topology.actions[static_cast<std::size_t>(a)].is_couple ? QuantityKind::moment
                                                                       : QuantityKind::force);
    }
    for (const Topology* one : {&topology, &analysis.mechanism.topology}) {
      for (int f = 0; f < one->freedom_count(); ++f) {
        add_unit(one->freedom_name(f),
                 one->freedoms[static_cast<std::size_t>(f)].is_rotation
                     ? QuantityKind::angular_velocity
                     : QuantityKind::velocity);
      }
    }
  }

  // Paths: the first key is the element, the rest the quantity. The words of a repair, what becomes
  // of which coupling, and of finite motions end the path of a 1; yes and no are 1 and 0.
  std::string run(const Json& mobility) {
    for (const auto& [key, value] : mobility.items()) {
      element_ = key;
      add("", "", value);
    }
    return std::move(text_);
  }

 private:
  void add_unit(const std::string& name, QuantityKind kind) {
    units_[name] = analysis_.description.units.text(kind);
  }

  void add(const std::string& path, const std::string& last, const Json& value) {
    if (value.is_object() || value.is_array()) {
      for (const auto& [key, item] : value.items()) {
        add(path.empty() ? key : path + "/" + key, key, item);
      }
    } else if (value.is_number()) {
      const auto unit = units_.find(last);
      const std::string number = value.is_number_integer() ? std::to_string(value.get<long>())
                                                           : format_exact(value.get<double>());
      row(path, number, unit == units_.end() ? "" : unit->second);
    } else if (has_words() && value.is_string()) {
      row(path + "/" + value.get<std::string>(), "1", "");
    } else if (has_words() && value.is_boolean()) {
      row(path, value.get<bool>() ? "1" : "0", "");
    }
  }

  bool has_words() const { return element_ == "repairs" || element_ == "finite"; }

  void row(const std::string& path, const std::string& number, const std::string& unit) {
    text_ += csv_line(
        std::array<std::string, 8>{name(), "", "mobility", element_, path, number, unit, "solved"});
  }

  std::string name() const {
    return analysis_.mechanism.name.empty() ? printable(analysis_.file) : analysis_.mechanism.name;
  }

  const MobilityAnalysis& analysis_;
  std::map<std::string, std::string> units_;  ///< of freedoms and actions
  std::string element_;
  std::string text_;
};

}  // namespace

std::string mobility_csv(const MobilityAnalysis& analysis, const Json& mobility) {
  return std::string(kCsvHeader) + MobilityCsv(analysis).run(mobility);
}

}  // namespace kinestat
