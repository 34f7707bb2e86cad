#include "expression/parameters/parameter_order.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/index.hpp"

namespace kinestat {

namespace {

// Takes what is ready, then what became ready by it; what is never ready hangs on a circle.
class OrderSearch {
 public:
  OrderSearch(std::span<const Parameter> parameters,
              const std::function<int(std::string_view)>& index_of);

  ParameterOrder run();

 private:
  void wait_for_names(int parameter);
  void release(int parameter);
  void report_circles();
  void walk(int start);
  void report_circle(std::vector<int> circle);
  int next_pending(int parameter) const;
  const Node& place_of(const Expression& expression, int parameter) const;

  std::span<const Parameter> parameters_;
  const std::function<int(std::string_view)>& index_of_;
  ParameterOrder result_;
  std::vector<std::vector<int>> users_;  // of each parameter
  std::vector<int> missing_;             // how many of those it uses are not yet done
  std::vector<int> walked_by_;           // the start of the walk that visited it, or -1
};

OrderSearch::OrderSearch(std::span<const Parameter> parameters,
                         const std::function<int(std::string_view)>& index_of)
    : parameters_(parameters),
      index_of_(index_of),
      users_(parameters.size()),
      missing_(parameters.size(), 0),
      walked_by_(parameters.size(), -1) {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    wait_for_names(static_cast<int>(i));
  }
}

void OrderSearch::wait_for_names(int parameter) {
  for (const std::string& name : parameters_[at(parameter)].value.names()) {
    const int used = index_of_(name);
    if (used >= 0) {
      users_[at(used)].push_back(parameter);
      ++missing_[at(parameter)];
    }
  }
}

ParameterOrder OrderSearch::run() {
  for (std::size_t i = 0; i < missing_.size(); ++i) {
    if (missing_[i] == 0) {
      result_.order.push_back(static_cast<int>(i));
    }
  }
  for (std::size_t done = 0; done < result_.order.size(); ++done) {
    release(result_.order[done]);
  }
  report_circles();
  return std::move(result_);
}

void OrderSearch::release(int parameter) {
  for (const int user : users_[at(parameter)]) {
    if (--missing_[at(user)] == 0) {
      result_.order.push_back(user);
    }
  }
}

void OrderSearch::report_circles() {
  for (std::size_t i = 0; i < missing_.size(); ++i) {
    if (missing_[i] > 0 && walked_by_[i] < 0) {
      walk(static_cast<int>(i));
    }
  }
}

// From one parameter to one that it waits for, and on, until the path meets itself (a new circle)
// or an older path, whose circle is known.
void OrderSearch::walk(int start) {
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

int OrderSearch::next_pending(int parameter) const {
  for (const std::string& name : parameters_[at(parameter)].value.names()) {
    const int used = index_of_(name);
    if (used >= 0 && missing_[at(used)] > 0) {
      return used;
    }
  }
  return parameter;  // not reached: what waits, waits for another that waits
}

void OrderSearch::report_circle(std::vector<int> circle) {
  constexpr std::size_t kLongestList = 12;
  std::rotate(circle.begin(), std::ranges::min_element(circle), circle.end());
  std::string list;
  for (std::size_t i = 0; i < std::min(circle.size(), kLongestList); ++i) {
    list += parameters_[at(circle[i])].name + " -> ";
  }
  list += circle.size() > kLongestList ? "... -> " : "";
  const Parameter& first = parameters_[at(circle[0])];
  const Node& place = place_of(first.value, circle[circle.size() == 1 ? 0 : 1]);
  result_.circles.push_back(
      {circle[0],
       {.offset = place.offset,
        .length = place.length,
        .code = "E0310",
        .message =
            fmt::format("parameters depend on each other in a circle: {}{}", list, first.name),
        .hint = "give one of them a value that does not use the others"}});
}

// Where an expression refers to a parameter.
const Node& OrderSearch::place_of(const Expression& expression, int parameter) const {
  const std::string& name = parameters_[at(parameter)].name;
  const auto nodes = expression.nodes();
  return *std::ranges::find_if(nodes, [&](const Node& node) {
    return node.kind == NodeKind::name && expression.text_of(node) == name;
  });
}

}  // namespace

ParameterOrder find_order(std::span<const Parameter> parameters,
                          const std::function<int(std::string_view)>& index_of) {
  return OrderSearch(parameters, index_of).run();
}

}  // namespace kinestat
