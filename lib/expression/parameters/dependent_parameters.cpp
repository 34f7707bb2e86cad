// Open parameters that follow from each other.
#include <algorithm>

#include <fmt/format.h>

#include "core/index.hpp"
#include "expression/parameters/parameter_order.hpp"

namespace kinestat {

namespace {

constexpr int kNone = -1;

// Follows the parameters in the order in which they need each other.
class DependenceSearch {
 public:
  DependenceSearch(std::span<const Parameter> parameters, std::span<const int> open)
      : parameters_(parameters),
        table_(parameters),
        is_open_(parameters.size(), false),
        source_(parameters.size(), kNone) {
    for (const int parameter : open) {
      is_open_[at(parameter)] = true;
    }
  }

  std::vector<ParameterError> run() {
    const auto index_of = [this](std::string_view name) { return table_.index_of(name); };
    for (const int parameter : find_order(parameters_, index_of).order) {
      source_[at(parameter)] = find_source(parameters_[at(parameter)].value);
      if (is_open_[at(parameter)] && source_[at(parameter)] != kNone) {
        refuse(parameter);
      }
    }
    std::ranges::stable_sort(errors_, {}, &ParameterError::parameter);
    return std::move(errors_);
  }

 private:
  // The open parameter that a value follows from, or kNone.
  int find_source(const Expression& value) const {
    for (const std::string& name : value.names()) {
      const int used = table_.index_of(name);
      const int source = used == kNone || is_open_[at(used)] ? used : source_[at(used)];
      if (source != kNone) {
        return source;
      }
    }
    return kNone;
  }

  void refuse(int parameter) {
    const Parameter& wrong = parameters_[at(parameter)];
    const std::string& text = wrong.value.text();
    errors_.push_back(
        {parameter,
         {.offset = 0,
          .length = static_cast<int>(text.size()),
          .code = "E0310",
          .message = fmt::format("'{}' is free and follows from '{}', which is free too",
                                 wrong.name,
                                 parameters_[at(source_[at(parameter)])].name),
          .hint = fmt::format("write '{}: {}', or give it a value of its own", wrong.name, text)}});
  }

  std::span<const Parameter> parameters_;
  ParameterTable table_;
  std::vector<bool> is_open_;
  std::vector<int> source_;  // of each: the open parameter that its value follows from
  std::vector<ParameterError> errors_;
};

}  // namespace

std::vector<ParameterError> find_dependent(std::span<const Parameter> parameters,
                                           std::span<const int> open) {
  return open.empty() ? std::vector<ParameterError>() : DependenceSearch(parameters, open).run();
}

}  // namespace kinestat
