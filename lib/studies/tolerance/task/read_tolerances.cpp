#include "studies/tolerance/task/read_tolerances.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <variant>

#include <fmt/format.h>

#include "core/index.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "expression/evaluate.hpp"
#include "mechanism/label_kind.hpp"

namespace kinestat {

namespace {

// What may deviate by how much, from the words of the command line.
class ToleranceReader {
 public:
  ToleranceReader(const Topology& topology,
                  const FileUnits& units,
                  std::span<const Case> cases,
                  const ToleranceChoice& choice,
                  Diagnostics& found)
      : topology_(topology), units_(units), cases_(cases), choice_(choice), found_(found) {}

  ReadTolerances run() {
    ReadTolerances result;
    result.place = read("--place", choice_.place, QuantityKind::length);
    result.angle = read("--angle", choice_.angle, QuantityKind::angle);
    for (const Case& one : cases_) {
      result.of_cases.push_back(
          {.places = std::vector<double>(topology_.couplings.size(), result.place),
           .angles = std::vector<double>(topology_.couplings.size(), result.angle),
           .drives = std::vector<double>(one.motions.size(), 0.0)});
    }
    for (const std::string& text : choice_.each) {
      set_each(text, result.of_cases);
    }
    return result;
  }

 private:
  void refuse(const std::string& option,
              const std::string& text,
              const std::string& message,
              const std::string& hint) {
    found_.error("E0101", {}, fmt::format("{} '{}': {}", option, printable(text), message), hint);
  }

  // Empty iff an error was added.
  std::optional<Quantity> quantity_of(const std::string& option,
                                      const std::string& text,
                                      const std::string& value) {
    const auto parsed = parse_expression(value);
    if (const auto* error = std::get_if<ExpressionError>(&parsed)) {
      refuse(option, text, error->message, error->hint);
      return std::nullopt;
    }
    const auto number = evaluate(std::get<Expression>(parsed), no_names);
    if (const auto* error = std::get_if<ExpressionError>(&number)) {
      refuse(option, text, error->message, error->hint);
      return std::nullopt;
    }
    return std::get<Quantity>(number);
  }

  double size_of(const std::string& option,
                 const std::string& text,
                 const Quantity& quantity,
                 QuantityKind kind) {
    const auto fitted = fit(quantity, kind, units_);
    if (const auto* error = std::get_if<ExpressionError>(&fitted)) {
      refuse(option, text, error->message, error->hint);
      return 0.0;
    }
    const double size = std::get<double>(fitted);
    if (size < 0.0) {
      refuse(option, text, "a tolerance to either side cannot be negative", "leave out the sign");
      return 0.0;
    }
    return size;
  }

  double read(const std::string& option,
              const std::optional<std::string>& text,
              QuantityKind kind) {
    const std::optional<Quantity> quantity =
        text ? quantity_of(option, *text, *text) : std::nullopt;
    return quantity ? size_of(option, *text, *quantity, kind) : 0.0;
  }

  void set_each(const std::string& text, std::vector<PartTolerances>& result) {
    const std::size_t sign = text.find('=');
    if (sign == std::string::npos) {
      refuse("--each", text, "there is no value", "write --each NAME=VALUE, as C=0.02mm");
      return;
    }
    const std::string name = text.substr(0, sign);
    const std::optional<Quantity> quantity = quantity_of("--each", text, text.substr(sign + 1));
    if (!quantity) {
      return;
    }
    const auto coupling = std::ranges::find(topology_.couplings, name, &CouplingTopology::name);
    const bool is_drive = set_drives(text, name, *quantity, result);
    if (coupling != topology_.couplings.end()) {
      set_coupling(text,
                   *quantity,
                   static_cast<std::size_t>(coupling - topology_.couplings.begin()),
                   result);
    } else if (!is_drive) {
      refuse("--each",
             text,
             "there is no such coupling, nor a drive that a case holds",
             guess_before(name, names(), "write one of " + plain_list(names())));
    }
  }

  // Whether a case holds a drive of that name, or of an actuator's.
  bool set_drives(const std::string& text,
                  const std::string& name,
                  const Quantity& quantity,
                  std::vector<PartTolerances>& result) {
    bool is_drive = false;
    for (std::size_t c = 0; c < cases_.size(); ++c) {
      const std::vector<Primary>& held = cases_[c].motions;
      for (std::size_t h = 0; h < held.size(); ++h) {
        if (held[h].given == name) {
          const int errors_before = found_.error_count();
          result[c].drives[h] =
              size_of("--each",
                      text,
                      quantity,
                      position_kind(topology_.freedoms[at(held[h].index)].is_rotation));
          if (found_.error_count() > errors_before) {
            return true;
          }
          is_drive = true;
        }
      }
    }
    return is_drive;
  }

  void set_coupling(const std::string& text,
                    const Quantity& quantity,
                    std::size_t coupling,
                    std::vector<PartTolerances>& result) {
    if (is_bare(quantity.dimension) && quantity.value != 0.0) {
      refuse("--each",
             text,
             "a place or an angle? A bare number does not say",
             "write a unit, as 0.02mm or 0.05deg");
      return;
    }
    const bool is_angle = fits(quantity.dimension, QuantityKind::angle);
    const double size = size_of("--each", text, quantity, position_kind(is_angle));
    for (PartTolerances& one : result) {
      (is_angle ? one.angles : one.places)[coupling] = size;
      if (is_bare(quantity.dimension)) {
        one.angles[coupling] = size;
      }
    }
  }

  std::vector<std::string> names() const {
    std::vector<std::string> result;
    std::ranges::transform(
        topology_.couplings, std::back_inserter(result), &CouplingTopology::name);
    for (const Case& one : cases_) {
      for (const Primary& held : one.motions) {
        if (std::ranges::find(result, held.given) == result.end()) {
          result.push_back(held.given);
        }
      }
    }
    return result;
  }

  const Topology& topology_;
  const FileUnits& units_;
  std::span<const Case> cases_;
  const ToleranceChoice& choice_;
  Diagnostics& found_;
};

}  // namespace

ReadTolerances read_tolerances(const Topology& topology,
                               const FileUnits& units,
                               std::span<const Case> cases,
                               const ToleranceChoice& choice,
                               Diagnostics& found) {
  return ToleranceReader(topology, units, cases, choice, found).run();
}

}  // namespace kinestat
