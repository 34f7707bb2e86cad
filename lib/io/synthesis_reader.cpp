#include "io/synthesis_reader.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "io/field_values.hpp"
#include "io/fields.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

constexpr Space kPlane = Space::planar;

// One angle, or a list of them.
std::vector<Value> read_angles(Fields& fields, Diagnostics& found) {
  std::vector<Value> angles;
  const YamlNode* node = fields.require("angle");
  if (node == nullptr) {
    return angles;
  }
  const std::string what = fmt::format("'angle' of {}", fields.what());
  if (node->kind == YamlKind::sequence &&
      !check_list(*node, what, "write angle: 30 deg, or a list of angles to try each", found)) {
    return angles;
  }
  const std::span<const YamlNode> items =
      node->kind == YamlKind::sequence ? std::span(node->items) : std::span(node, 1);
  for (const YamlNode& item : items) {
    if (auto angle = read_value(item, what, found)) {
      angles.push_back(*std::move(angle));
    }
  }
  return angles;
}

std::optional<CurvatureDescription> find_curvature(Fields& fields, Diagnostics& found) {
  const YamlNode* node = fields.find("curvature");
  if (node == nullptr) {
    return std::nullopt;
  }
  CurvatureDescription curvature;
  curvature.where = node->where;
  Fields inner(*node, node->where, fmt::format("'curvature' of {}", fields.what()), found);
  curvature.centre = require_point(inner, "centre", kPlane, found);
  curvature.free_point = find_point(inner, "free_point", kPlane, found);
  curvature.m = find_value(inner, "m", found);
  inner.finish();
  return curvature;
}

// Either the parameter of the motion is the angle, or every derivative says how the angle moves.
void check_angles(const std::vector<PoseDerivative>& derivatives,
                  const YamlNode& node,
                  const std::string& what,
                  Diagnostics& found) {
  const auto has_angle = [](const PoseDerivative& one) { return one.angle.has_value(); };
  if (std::ranges::any_of(derivatives, has_angle) && !std::ranges::all_of(derivatives, has_angle)) {
    found.error("E0303",
                node.where,
                fmt::format("only some derivatives of {} have an 'angle'", what),
                "give 'angle' in all of them, or in none if the parameter is the angle itself");
  }
}

std::vector<PoseDerivative> find_derivatives(Fields& fields, Diagnostics& found) {
  constexpr std::size_t kMost = 4;
  std::vector<PoseDerivative> derivatives;
  const YamlNode* node = fields.find("derivatives");
  if (node == nullptr) {
    return derivatives;
  }
  if (node->kind != YamlKind::sequence || node->items.empty() || node->items.size() > kMost) {
    found.error("E0304",
                node->where,
                fmt::format("'derivatives' of {} must be a list of one to four", fields.what()),
                "write derivatives: [{at: [x, y], angle: 1 rad}, …], the first derivative first");
    return derivatives;
  }
  for (std::size_t i = 0; i < node->items.size(); ++i) {
    const YamlNode& item = node->items[i];
    Fields inner(item, item.where, fmt::format("derivative {} of {}", i + 1, fields.what()), found);
    PoseDerivative derivative;
    derivative.at = require_point(inner, "at", kPlane, found);
    derivative.angle = find_value(inner, "angle", found);
    inner.finish();
    derivatives.push_back(std::move(derivative));
  }
  check_angles(derivatives, *node, fields.what(), found);
  return derivatives;
}

// Each order of contact needs the one before; derivatives say all of them in another way.
void check_orders(const YamlNode& node, const std::string& what, Diagnostics& found) {
  static const std::vector<std::string> kOrders = {"pole", "curvature", "stationary", "burmester"};
  const bool has_derivatives = node.find("derivatives") != nullptr;
  for (std::size_t i = 0; i < kOrders.size(); ++i) {
    if (node.find(kOrders[i]) == nullptr) {
      continue;
    }
    if (has_derivatives) {
      found.error("E0302",
                  place_of_key(node, kOrders[i]),
                  fmt::format("{} cannot have '{}' beside 'derivatives'", what, kOrders[i]),
                  "keep one of the two: both say how the plane moves there");
    } else if (i > 0 && node.find(kOrders[i - 1]) == nullptr) {
      found.error("E0303",
                  place_of_key(node, kOrders[i]),
                  fmt::format("'{}' of {} needs '{}' beside it", kOrders[i], what, kOrders[i - 1]),
                  "the orders are pole, curvature, stationary, burmester; each needs the one "
                  "before");
    }
  }
}

PositionDescription read_position(const YamlNode& node,
                                  const std::string& what,
                                  Diagnostics& found) {
  PositionDescription position;
  position.where = node.where;
  Fields fields(node, node.where, what, found);
  position.at = require_point(fields, "at", kPlane, found);
  position.angles = read_angles(fields, found);
  position.pole = find_point(fields, "pole", kPlane, found);
  position.curvature = find_curvature(fields, found);
  position.stationary = find_bool(fields, "stationary", found);
  position.burmester = find_bool(fields, "burmester", found);
  position.derivatives = find_derivatives(fields, found);
  fields.finish();
  check_orders(node, what, found);
  if (position.burmester && !position.stationary && node.find("stationary") != nullptr) {
    found.error("E0303",
                place_of_key(node, "burmester"),
                fmt::format("'burmester' of {} needs 'stationary: true'", what),
                "write stationary: true, or burmester: false");
  }
  return position;
}

std::vector<PositionDescription> read_positions(const YamlNode& node, Diagnostics& found) {
  std::vector<PositionDescription> positions;
  if (!check_list(node,
                  "'positions' of 'synthesis'",
                  "begin each position with '- {at: [x, y], angle: 30 deg}'",
                  found)) {
    return positions;
  }
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    positions.push_back(read_position(node.items[i], fmt::format("position {}", i + 1), found));
  }
  return positions;
}

SynthesisLimits find_limits(Fields& fields, Diagnostics& found) {
  SynthesisLimits limits;
  const YamlNode* node = fields.find("limits");
  if (node == nullptr) {
    return limits;
  }
  Fields inner(*node, node->where, "'limits' of 'synthesis'", found);
  limits.transmission_angle = find_value(inner, "transmission_angle", found);
  limits.link_ratio = find_value(inner, "link_ratio", found);
  limits.size = find_value(inner, "size", found);
  inner.finish();
  return limits;
}

std::optional<SynthesisRange> find_range(Fields& vary,
                                         const YamlNode& node,
                                         FreeNumber which,
                                         Diagnostics& found) {
  const std::string key(word_of(which));
  const YamlNode* range = vary.find(key);
  if (range == nullptr) {
    return std::nullopt;
  }
  Fields fields(*range, range->where, fmt::format("'{}' of 'vary'", key), found);
  SynthesisRange result;
  result.which = which;
  result.name_where = place_of_key(node, key);
  result.where = range->where;
  if (is_point(which)) {
    result.from = require_point(fields, "from", kPlane, found).coordinates;
    result.to = require_point(fields, "to", kPlane, found).coordinates;
  } else {
    result.from.push_back(require_value(fields, "from", found));
    result.to.push_back(require_value(fields, "to", found));
  }
  fields.finish();
  return result;
}

void read_vary(const YamlNode& node, SynthesisDescription& synthesis, Diagnostics& found) {
  using enum FreeNumber;
  const int errors_before = found.error_count();
  Fields fields(node, node.where, "'vary' of 'synthesis'", found);
  for (const FreeNumber which : {m, free_point, s, tau, tau_2, circle_points}) {
    if (auto range = find_range(fields, node, which, found)) {
      synthesis.vary.push_back(*std::move(range));
    }
  }
  synthesis.samples = find_value(fields, "samples", found);
  fields.finish();
  if (synthesis.vary.empty() && found.error_count() == errors_before) {
    found.error("E0303",
                node.where,
                "'vary' names nothing that is free",
                "write for example vary: {m: {from: 0.2, to: 3}}");
  }
}

// To ask for curves is enough.
std::optional<Value> find_curve_count(Fields& fields, Diagnostics& found) {
  constexpr std::string_view kUsual = "200";
  const YamlNode* node = fields.find("curves");
  if (node == nullptr) {
    return std::nullopt;
  }
  Fields inner(*node, node->where, "'curves' of 'synthesis'", found);
  std::optional<Value> count = find_value(inner, "count", found);
  inner.finish();
  return node->entries.empty()
             ? std::optional(Value{.expression = std::get<Expression>(parse_expression(kUsual)),
                                   .where = node->where,
                                   .text_column = 0})
             : count;
}

}  // namespace

std::optional<SynthesisDescription> read_synthesis(const YamlNode& node, Diagnostics& found) {
  static const std::vector<std::string> kLinkages = {
      "any", "four_bar", "slider_crank", "inverted_slider_crank"};
  const int errors_before = found.error_count();
  SynthesisDescription synthesis;
  synthesis.where = node.where;
  Fields fields(node, node.where, "'synthesis'", found);
  if (const auto word = find_word(fields, "linkage", kLinkages, found)) {
    synthesis.linkage = static_cast<LinkageKind>(*word);
  }
  if (const YamlNode* positions = fields.require("positions")) {
    synthesis.positions = read_positions(*positions, found);
  }
  synthesis.limits = find_limits(fields, found);
  if (const YamlNode* vary = fields.find("vary")) {
    read_vary(*vary, synthesis, found);
  }
  synthesis.curve_count = find_curve_count(fields, found);
  synthesis.digits = find_value(fields, "digits", found);
  fields.finish();
  return found.error_count() == errors_before ? std::optional(std::move(synthesis)) : std::nullopt;
}

}  // namespace kinestat
