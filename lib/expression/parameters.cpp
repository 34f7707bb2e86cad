#include "expression/parameters.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace kinestat {

namespace {

// Evaluates what is ready, then what became ready by it; what is never ready hangs on a circle.
class ParameterRun {
 public:
  explicit ParameterRun(std::span<const Parameter> parameters);

  ParameterValues run();

 private:
  void evaluate_one(int parameter);
  void release(int parameter);
  void report_circles();
  void walk(int start);
  void report_circle(std::vector<int> circle);
  int next_pending(int parameter) const;
  const Node& place_of(const Expression& expression, int parameter) const;

  std::span<const Parameter> parameters_;
  ParameterValues result_;
  std::vector<std::vector<int>> users_;  // of each parameter
  std::vector<int> missing_;             // how many of those it uses are not yet done
  std::vector<int> ready_;
  std::vector<int> walked_by_;  // the start of the walk that visited it, or -1
};

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

ParameterRun::ParameterRun(std::span<const Parameter> parameters)
    : parameters_(parameters),
      result_{ParameterTable(parameters), {}},
      users_(parameters.size()),
      missing_(parameters.size(), 0),
      walked_by_(parameters.size(), -1) {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    for (const std::string& name : parameters[i].value.names()) {
      const int used = result_.table.index_of(name);
      if (used >= 0) {
        users_[at(used)].push_back(static_cast<int>(i));
        ++missing_[i];
      }
    }
  }
}

ParameterValues ParameterRun::run() {
  for (std::size_t i = 0; i < missing_.size(); ++i) {
    if (missing_[i] == 0) {
      ready_.push_back(static_cast<int>(i));
    }
  }
  for (std::size_t done = 0; done < ready_.size(); ++done) {
    evaluate_one(ready_[done]);
    release(ready_[done]);
  }
  report_circles();
  std::stable_sort(
      result_.errors.begin(),
      result_.errors.end(),
      [](const ParameterError& a, const ParameterError& b) { return a.parameter < b.parameter; });
  return std::move(result_);
}

void ParameterRun::evaluate_one(int parameter) {
  const Expression& expression = parameters_[at(parameter)].value;
  if (result_.table.is_failed(expression)) {
    return;
  }
  const ParameterTable& table = result_.table;
  auto outcome = evaluate(expression, table.lookup(), table.names());
  if (auto* error = std::get_if<ExpressionError>(&outcome)) {
    result_.errors.push_back({parameter, std::move(*error)});
    return;
  }
  result_.table.set(parameter, std::get<Quantity>(outcome));
}

void ParameterRun::release(int parameter) {
  for (const int user : users_[at(parameter)]) {
    if (--missing_[at(user)] == 0) {
      ready_.push_back(user);
    }
  }
}

void ParameterRun::report_circles() {
  for (std::size_t i = 0; i < missing_.size(); ++i) {
    if (missing_[i] > 0 && walked_by_[i] < 0) {
      walk(static_cast<int>(i));
    }
  }
}

// From one parameter to one that it waits for, and on, until the path meets itself (a new circle)
// or an older path, whose circle is known.
void ParameterRun::walk(int start) {
  std::vector<int> path;
  int here = start;
  while (walked_by_[at(here)] < 0) {
    walked_by_[at(here)] = start;
    path.push_back(here);
    here = next_pending(here);
  }
  if (walked_by_[at(here)] == start) {
    report_circle({std::ranges::find(path, here), path.end()});
  }
}

int ParameterRun::next_pending(int parameter) const {
  for (const std::string& name : parameters_[at(parameter)].value.names()) {
    const int used = result_.table.index_of(name);
    if (used >= 0 && missing_[at(used)] > 0) {
      return used;
    }
  }
  return parameter;  // not reached: what waits, waits for another that waits
}

void ParameterRun::report_circle(std::vector<int> circle) {
  constexpr std::size_t kLongestList = 12;
  std::rotate(circle.begin(), std::ranges::min_element(circle), circle.end());
  std::string list;
  for (std::size_t i = 0; i < std::min(circle.size(), kLongestList); ++i) {
    list += parameters_[at(circle[i])].name + " -> ";
  }
  list += circle.size() > kLongestList ? "... -> " : "";
  const Parameter& first = parameters_[at(circle[0])];
  const Node& place = place_of(first.value, circle[circle.size() == 1 ? 0 : 1]);
  result_.errors.push_back(
      {circle[0],
       {.offset = place.offset,
        .length = place.length,
        .code = "E0310",
        .message =
            fmt::format("parameters depend on each other in a circle: {}{}", list, first.name),
        .hint = "give one of them a value that does not use the others"}});
}

// Where an expression refers to a parameter.
const Node& ParameterRun::place_of(const Expression& expression, int parameter) const {
  const std::string& name = parameters_[at(parameter)].name;
  const auto nodes = expression.nodes();
  return *std::ranges::find_if(nodes, [&](const Node& node) {
    return node.kind == NodeKind::name && expression.text_of(node) == name;
  });
}

}  // namespace

ParameterTable::ParameterTable(std::span<const Parameter> parameters)
    : entries_(parameters.size()) {
  for (const Parameter& parameter : parameters) {
    index_.emplace(parameter.name, static_cast<int>(names_.size()));
    names_.push_back(parameter.name);
  }
  for (const Parameter& parameter : parameters) {
    mark_used(parameter.value);
  }
}

const Quantity* ParameterTable::find(std::string_view name) const {
  const int index = index_of(name);
  return index >= 0 && entries_[at(index)].has_value ? &entries_[at(index)].value : nullptr;
}

NameLookup ParameterTable::lookup() const {
  return [this](std::string_view name) { return find(name); };
}

bool ParameterTable::is_failed(const Expression& expression) const {
  return std::ranges::any_of(expression.names(), [this](const std::string& name) {
    return index_of(name) >= 0 && find(name) == nullptr;
  });
}

void ParameterTable::mark_used(const Expression& expression) {
  for (const std::string& name : expression.names()) {
    const int index = index_of(name);
    if (index >= 0) {
      entries_[at(index)].is_used = true;
    }
  }
}

std::vector<int> ParameterTable::unused() const {
  std::vector<int> result;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (!entries_[i].is_used) {
      result.push_back(static_cast<int>(i));
    }
  }
  return result;
}

int ParameterTable::index_of(std::string_view name) const {
  const auto found = index_.find(name);
  return found != index_.end() ? found->second : -1;
}

void ParameterTable::set(int parameter, const Quantity& value) {
  entries_[at(parameter)].value = value;
  entries_[at(parameter)].has_value = true;
}

ParameterValues evaluate_parameters(std::span<const Parameter> parameters) {
  return ParameterRun(parameters).run();
}

}  // namespace kinestat
