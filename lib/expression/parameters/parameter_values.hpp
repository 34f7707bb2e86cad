// The functions of parameters.hpp for any type of number; each type has one source that includes
// it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "expression/parameters.hpp"
#include "expression/parameters/parameter_order.hpp"

namespace kinestat {

template <class Number>
BasicParameterTable<Number>::BasicParameterTable(std::span<const Parameter> parameters)
    : entries_(parameters.size()) {
  for (const Parameter& parameter : parameters) {
    index_.emplace(parameter.name, static_cast<int>(names_.size()));
    names_.push_back(parameter.name);
  }
  for (const Parameter& parameter : parameters) {
    mark_used(parameter.value);
  }
}

template <class Number>
const BasicQuantity<Number>* BasicParameterTable<Number>::find(std::string_view name) const {
  const int index = index_of(name);
  return index >= 0 && entries_[static_cast<std::size_t>(index)].has_value
             ? &entries_[static_cast<std::size_t>(index)].value
             : nullptr;
}

template <class Number>
BasicNameLookup<Number> BasicParameterTable<Number>::lookup() const {
  return [this](std::string_view name) { return find(name); };
}

template <class Number>
bool BasicParameterTable<Number>::is_failed(std::span<const std::string> used) const {
  return std::ranges::any_of(used, [this](const std::string& name) {
    return index_of(name) >= 0 && find(name) == nullptr;
  });
}

template <class Number>
void BasicParameterTable<Number>::mark_used(std::span<const std::string> used) {
  for (const std::string& name : used) {
    const int index = index_of(name);
    if (index >= 0) {
      entries_[static_cast<std::size_t>(index)].is_used = true;
    }
  }
}

template <class Number>
std::vector<int> BasicParameterTable<Number>::unused() const {
  std::vector<int> result;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (!entries_[i].is_used) {
      result.push_back(static_cast<int>(i));
    }
  }
  return result;
}

template <class Number>
int BasicParameterTable<Number>::index_of(std::string_view name) const {
  const auto found = index_.find(name);
  return found != index_.end() ? found->second : -1;
}

template <class Number>
void BasicParameterTable<Number>::set(int parameter, const BasicQuantity<Number>& value) {
  entries_[static_cast<std::size_t>(parameter)].value = value;
  entries_[static_cast<std::size_t>(parameter)].has_value = true;
}

/// `adjust(index, value)` may change a value before others use it.
template <class Number, class Adjust>
BasicParameterValues<Number> evaluate_in_order(std::span<const Parameter> parameters,
                                               const Adjust& adjust) {
  BasicParameterValues<Number> result{BasicParameterTable<Number>(parameters), {}};
  BasicParameterTable<Number>& table = result.table;
  ParameterOrder found =
      find_order(parameters, [&](std::string_view name) { return table.index_of(name); });
  result.errors = std::move(found.circles);
  for (const int parameter : found.order) {
    const Expression& expression = parameters[static_cast<std::size_t>(parameter)].value;
    if (table.is_failed(expression)) {
      continue;
    }
    // Guesses cost a search among all names; no more errors than these are shown.
    constexpr std::size_t kMostHints = 20;
    const auto known =
        result.errors.size() < kMostHints ? table.names() : std::span<const std::string>();
    auto outcome = evaluate<Number>(expression, table.lookup(), known);
    if (auto* error = std::get_if<ExpressionError>(&outcome)) {
      constexpr std::size_t kMostHintsKept = 1000;  // of more nobody reads
      if (result.errors.size() >= kMostHintsKept) {
        error->hint = std::string();
      }
      result.errors.push_back({parameter, std::move(*error)});
      continue;
    }
    adjust(parameter, std::get<BasicQuantity<Number>>(outcome));
    table.set(parameter, std::get<BasicQuantity<Number>>(outcome));
  }
  std::ranges::stable_sort(result.errors, {}, &ParameterError::parameter);
  return result;
}

template <class Number>
BasicParameterValues<Number> evaluate_parameters(std::span<const Parameter> parameters) {
  return evaluate_in_order<Number>(parameters, [](int, const auto&) {});
}

}  // namespace kinestat
