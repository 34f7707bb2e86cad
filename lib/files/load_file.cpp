#include "files/load_file.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "expression/parameters.hpp"
#include "files/curve_table.hpp"
#include "files/parameter_names.hpp"
#include "format/mechanism_reader.hpp"
#include "io/yaml_tree.hpp"
#include "mechanism/bind/bind.hpp"
#include "mechanism/motion_figure.hpp"
#include "studies/shift/task/gear_cases.hpp"

namespace kinestat {

namespace {

void refuse(const Override& text, std::string message, std::string hint, Diagnostics& found) {
  found.error(
      "E0102", {}, fmt::format("--set '{}': {}", printable(text), message), std::move(hint));
}

void apply(const Override& text, MechanismDescription& description, Diagnostics& found) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    refuse(text, "this is not PARAMETER=VALUE", "write for example --set N1=24", found);
    return;
  }
  const std::string name = text.substr(0, equals);
  const auto parameter = std::ranges::find(
      description.parameters, name, [](const ParameterDescription& p) { return p.name.text; });
  if (parameter == description.parameters.end()) {
    refuse(text,
           fmt::format("the file has no parameter '{}'", printable(name)),
           parameter_hint(name, description, text.substr(equals + 1)),
           found);
    return;
  }
  auto parsed = parse_expression(text.substr(equals + 1));
  if (const auto* error = std::get_if<ExpressionError>(&parsed)) {
    refuse(text, error->message, error->hint, found);
    return;
  }
  parameter->value.expression = std::get<Expression>(std::move(parsed));
  parameter->value.text_column = 0;
  parameter->set_by = text;
}

Expression zero_of(const Dimension& dimension) {
  auto parsed = parse_expression(fmt::format("0 {}", si_unit_of(dimension)));
  KINESTAT_EXPECTS(std::holds_alternative<Expression>(parsed));
  return std::get<Expression>(std::move(parsed));
}

// Bare, a length of the file would silently count in the file's unit wherever it is used; zero is
// zero in every unit. Where the file has a bare number, the places that use it decide what it may
// be.
void check_dimensions(const std::vector<Parameter>& given,
                      MechanismDescription& description,
                      Diagnostics& found) {
  const ParameterTable before = evaluate_parameters(given).table;
  const ParameterTable after = evaluate_parameters(parameters_of(description)).table;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const Quantity* const was = before.find(given[i].name);
    const Quantity* const is = after.find(given[i].name);
    const Override& text = description.parameters[i].set_by;
    const bool has_both = !text.empty() && was != nullptr && is != nullptr;
    if (has_both && !is_bare(was->dimension) && is_bare(is->dimension) && is->value == 0.0) {
      description.parameters[i].value.expression = zero_of(was->dimension);
    } else if (has_both && !is_bare(was->dimension) && was->dimension != is->dimension) {
      refuse(text,
             fmt::format("'{}' is {} in the file, and this is {}",
                         given[i].name,
                         phrase_of(was->dimension),
                         phrase_of(is->dimension)),
             fmt::format("write a value with a unit, as the file does: {}", given[i].value.text()),
             found);
    }
  }
}

std::optional<Loaded> with_gears(MechanismDescription description,
                                 std::optional<Mechanism> mechanism,
                                 Diagnostics& found,
                                 const ShiftOptions& sizes) {
  if (!mechanism) {
    if (!found.has_errors()) {
      refuse_without_mechanism(description, found);
    }
    return std::nullopt;
  }
  Loaded loaded{.description = std::move(description),
                .mechanism = *std::move(mechanism),
                .shift = std::nullopt};
  loaded.shift = add_gears(loaded.description, loaded.mechanism, sizes, found);
  return found.has_errors() ? std::nullopt : std::optional(std::move(loaded));
}

}  // namespace

std::vector<std::string> input_paths(const std::vector<std::string>& paths,
                                     const LoadOptions& options) {
  std::vector<std::string> all = paths;
  for (const std::string& curve : options.curves) {
    all.push_back(curve.substr(curve.find('=') + 1));
  }
  return all;
}

void apply_overrides(const std::vector<Override>& overrides,
                     MechanismDescription& description,
                     Diagnostics& found) {
  const std::vector<Parameter> given = parameters_of(description);
  for (const Override& text : overrides) {
    apply(text, description, found);
  }
  check_dimensions(given, description, found);
}

std::optional<MechanismDescription> read_description(const SourceFile& source,
                                                     const LoadOptions& options,
                                                     Diagnostics& found) {
  const std::optional<YamlNode> tree = read_yaml(source, options.limits, found);
  if (!tree) {
    return std::nullopt;
  }
  std::optional<MechanismDescription> description = read_mechanism(*tree, found);
  if (!description) {
    return std::nullopt;
  }
  if (!options.overrides.empty()) {
    apply_overrides(options.overrides, *description, found);
  }
  for (const std::string& text : options.curves) {
    apply_curve_table(text, options.limits, *description, found);
  }
  return found.has_errors() ? std::nullopt : std::move(description);
}

std::optional<MechanismDescription> load_description(const std::string& path,
                                                     const LoadOptions& options,
                                                     SourceFile& source,
                                                     Diagnostics& found) {
  source.path = path;
  std::optional<SourceFile> file = read_file(path, options.limits, found);
  if (!file) {
    return std::nullopt;
  }
  source = *std::move(file);
  return read_description(source, options, found);
}

void refuse_without_mechanism(const MechanismDescription& description, Diagnostics& found) {
  found.error(
      "E0303",
      {},
      "the file holds no mechanism",
      description.synthesis
          ? "it is a task for 'kinestat synthesize', which writes the linkages that it finds "
            "as mechanisms: --write-mechanism FOLDER"
          : "add ground, bodies and couplings");
}

std::optional<Loaded> bind_swept(MechanismDescription description,
                                 Diagnostics& found,
                                 const ShiftOptions& sizes) {
  const bool is_of_motion = sweeps_motion_alone(description);
  std::optional<Mechanism> mechanism =
      is_of_motion ? bind_unassembled(description, found) : bind(description, found);
  return with_gears(std::move(description), std::move(mechanism), found, sizes);
}

std::optional<Loaded> bind_loaded(MechanismDescription description,
                                  Diagnostics& found,
                                  const ShiftOptions& sizes) {
  std::optional<Mechanism> mechanism = bind(description, found);
  return with_gears(std::move(description), std::move(mechanism), found, sizes);
}

std::optional<Loaded> load(const std::string& path,
                           const LoadOptions& options,
                           SourceFile& source,
                           Diagnostics& found,
                           const ShiftOptions& sizes) {
  std::optional<MechanismDescription> description = load_description(path, options, source, found);
  return description ? bind_loaded(*std::move(description), found, sizes) : std::nullopt;
}

}  // namespace kinestat
