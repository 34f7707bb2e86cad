// The named values of a mechanism file, which may use one another in any order.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/source.hpp"
#include "expression/evaluate.hpp"
#include "expression/expression.hpp"

namespace kinestat {

struct Dual;

/// One entry of the section `parameters:`. Names are unique and not reserved (is_reserved_name).
struct Parameter {
  std::string name;
  Expression value;
  SourceRange name_where;
};

/// What is wrong with the value of one parameter.
struct ParameterError {
  int parameter = 0;  ///< index into the list that was evaluated
  ExpressionError error;
};

/// The values of all parameters that have one, and which of them are referred to. For the types of
/// number see BasicQuantity.
template <class Number>
class BasicParameterTable {
 public:
  BasicParameterTable() = default;
  explicit BasicParameterTable(std::span<const Parameter> parameters);

  /// The value in SI, or null if the name is unknown or its value is in error.
  const BasicQuantity<Number>* find(std::string_view name) const;

  /// find for evaluate. The table must outlive it.
  BasicNameLookup<Number> lookup() const;

  /// All names, in the order of the list, also those in error.
  std::span<const std::string> names() const { return names_; }

  /// Whether the expression uses a parameter whose value is in error: then it has no value either,
  /// and nothing more is to be said about it.
  bool is_failed(const Expression& expression) const { return is_failed(expression.names()); }

  bool is_failed(std::span<const std::string> used) const;

  /// Notes the names that an expression outside the table uses.
  void mark_used(const Expression& expression) { mark_used(expression.names()); }

  void mark_used(std::span<const std::string> used);

  /// The indices of those that no expression uses, in the order of the list. One that another
  /// parameter uses counts as used.
  std::vector<int> unused() const;

  /// The index of a name, or -1.
  int index_of(std::string_view name) const;

  /// Gives a parameter its value, once all that it uses have theirs.
  void set(int parameter, const BasicQuantity<Number>& value);

 private:
  struct Entry {
    BasicQuantity<Number> value;
    bool has_value = false;
    bool is_used = false;
  };

  std::vector<std::string> names_;
  std::vector<Entry> entries_;
  std::map<std::string, int, std::less<>> index_;
};

using ParameterTable = BasicParameterTable<double>;

/// The table and all that is wrong, ordered by parameter.
template <class Number>
struct BasicParameterValues {
  BasicParameterTable<Number> table;
  std::vector<ParameterError> errors;
};

using ParameterValues = BasicParameterValues<double>;

/// Evaluates the parameters in the order in which they need each other. Errors: those of evaluate,
/// and E0310 once for every circle, at its first parameter. Those that depend on a parameter in
/// error have no value and no error of their own. `Number` is double, Exact or ExactInput.
template <class Number = double>
BasicParameterValues<Number> evaluate_parameters(std::span<const Parameter> parameters);

/// With derivatives: the one of index i is per SI unit of the parameter variables[i], while all
/// that use it follow, as with --set.
BasicParameterValues<Dual> evaluate_parameters(std::span<const Parameter> parameters,
                                               std::span<const int> variables);

/// The indices of parameters, each after those that it uses. Those in a circle are left out.
std::vector<int> evaluation_order(std::span<const Parameter> parameters);

/// What is wrong with parameters that are left open independently of each other, given by index:
/// E0310 for each whose value uses another of them, if only through parameters that are not open.
std::vector<ParameterError> find_dependent(std::span<const Parameter> parameters,
                                           std::span<const int> open);

}  // namespace kinestat
