#include "report/shift_csv.hpp"

#include <array>

#include "core/utf8.hpp"
#include "report/analysis_csv.hpp"
#include "report/csv.hpp"
#include "report/numbers.hpp"

namespace kinestat {

namespace {

class ShiftCsv {
 public:
  explicit ShiftCsv(const Analysis& analysis) : analysis_(analysis) {}

  std::string run(const Json& shift) {
    status_ = "solved";
    for (const char* count : {"possibilities", "net_freedom", "engaged", "span"}) {
      row("", count, shift[count]);
    }
    for (const auto& [name, state] : shift["states"].items()) {
      state_ = name;
      status_ = state["class"].get<std::string>();
      add_state(state);
    }
    return std::move(text_);
  }

 private:
  void add_state(const Json& state) {
    for (const Json& element : state["engaged"]) {
      row(element.get<std::string>(), "engaged", 1);
    }
    for (const auto& [key, value] : state.items()) {
      if (key == "elements") {
        add_elements(value);
      } else if (value.is_object()) {
        for (const auto& [part, item] : value.items()) {
          add_number(key + "/" + part, item);
        }
      } else {
        add_number(key, value);
      }
    }
  }

  void add_elements(const Json& elements) {
    for (const auto& [name, element] : elements.items()) {
      for (const auto& [quantity, value] : element.items()) {
        row(name, quantity, value);
      }
    }
  }

  void add_number(const std::string& quantity, const Json& value) {
    if (value.is_number() || (value.is_null() && quantity != "direction")) {
      row("", quantity, value);
    }
  }

  void row(const std::string& element, const std::string& quantity, const Json& value) {
    const std::string number = value.is_null()             ? ""
                               : value.is_number_integer() ? std::to_string(value.get<long>())
                                                           : format_exact(value.get<double>());
    text_ += csv_line(std::array<std::string, 8>{
        analysis_.mechanism.name.empty() ? printable(analysis_.file) : analysis_.mechanism.name,
        state_,
        "shift",
        element,
        quantity,
        number,
        unit_of(quantity),
        status_});
  }

  std::string unit_of(const std::string& quantity) const {
    const FileUnits& units = analysis_.description.units;
    if (quantity == "torque") {
      return units.text(QuantityKind::moment);
    }
    if (quantity == "slip") {
      return units.text(QuantityKind::angular_velocity);
    }
    return quantity.ends_with("/force") ? units.text(QuantityKind::force) : "";
  }

  const Analysis& analysis_;
  std::string text_ = std::string(kCsvHeader);
  std::string state_;
  std::string status_;
};

}  // namespace

std::string shift_csv(const Analysis& analysis, const Json& shift) {
  return ShiftCsv(analysis).run(shift);
}

}  // namespace kinestat
