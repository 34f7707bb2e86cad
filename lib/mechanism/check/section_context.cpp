#include "mechanism/check/section_context.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace kinestat {

namespace {

bool is_computed(const Expression& expression) {
  const auto is_number = [](const Node& node) { return node.kind == NodeKind::number; };
  return !expression.names().empty() || std::ranges::count_if(expression.nodes(), is_number) > 1;
}

NumberRule anything_of(QuantityKind kind) {
  return {.kind = kind, .range = kAnyNumber, .allowed = "a number"};
}

// The number as typed; what is computed has its result beside it.
std::string shown(const Value& value, double number, QuantityKind kind, const FileUnits& units) {
  const Expression& expression = value.expression;
  if (!is_computed(expression)) {
    return expression.text();
  }
  const std::string& unit = units.text(kind);
  return fmt::format("{} = {:.10g}{}{}",
                     expression.text(),
                     units.from_si(kind, number),
                     unit.empty() ? "" : " ",
                     unit);
}

}  // namespace

std::optional<double> SectionContext::look_at(const Value& value, const NumberRule& rule) const {
  if (checked == nullptr) {
    return evaluator.number(value, rule.kind);
  }
  checked->push_back({.value = value, .rule = rule});
  std::vector<const Value*>* const noted = evaluator.note_numbers(nullptr);
  const std::optional<double> result = evaluator.number(value, rule.kind);
  evaluator.note_numbers(noted);
  return result;
}

std::optional<double> SectionContext::number(const std::optional<Value>& value,
                                             const NumberRule& rule,
                                             std::string_view what) const {
  const std::optional<double> result = value ? look_at(*value, rule) : std::nullopt;
  if (!result || rule.range.holds(*result)) {
    return result;
  }
  found.error(
      "E0305",
      value->where,
      fmt::format("{} cannot be {}", what, shown(*value, *result, rule.kind, description.units)),
      fmt::format("write {}", rule.allowed));
  return std::nullopt;
}

std::optional<Vec3> SectionContext::vector(const std::vector<Value>& components,
                                           QuantityKind kind) const {
  Vec3 result = Vec3::Zero();
  bool is_good = true;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const std::optional<double> component = look_at(components[i], anything_of(kind));
    is_good = is_good && component.has_value();
    result[static_cast<Eigen::Index>(i)] = component.value_or(0.0);
  }
  return is_good ? std::optional(result) : std::nullopt;
}

std::optional<Vec3> SectionContext::place(const PointDescription& point) const {
  if (checked == nullptr) {
    return evaluator.point(point);
  }
  for (const Value& coordinate : point.coordinates) {
    checked->push_back({.value = coordinate, .rule = anything_of(QuantityKind::length)});
  }
  std::vector<const Value*>* const noted = evaluator.note_numbers(nullptr);
  const std::optional<Vec3> result = evaluator.point(point);
  evaluator.note_numbers(noted);
  return result;
}

void SectionContext::components(const std::vector<Value>& values, QuantityKind kind) const {
  for (const Value& value : values) {
    look_at(value, anything_of(kind));
  }
}

void SectionContext::point(const std::optional<PointDescription>& point) const {
  if (point) {
    components(point->coordinates, QuantityKind::length);
  }
}

bool SectionContext::repeats(const std::vector<Name>& list, std::string_view what) const {
  std::map<std::string_view, SourceRange> seen;
  bool is_repeated = false;
  for (const Name& name : list) {
    const auto [at, is_new] = seen.emplace(name.text, name.where);
    if (!is_new) {
      is_repeated = true;
      auto& problem = found.error("E0307",
                                  name.where,
                                  fmt::format("{} names '{}' twice", what, name.text),
                                  "remove one of the two");
      problem.notes.push_back({at->second, "first named here"});
    }
  }
  return is_repeated;
}

}  // namespace kinestat
