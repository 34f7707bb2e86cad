#include "mechanism/bind/override_blame.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/utf8.hpp"

namespace kinestat {

namespace {

bool is_set(const ParameterDescription& parameter) {
  return !parameter.set_by.empty() && parameter.in_file;
}

void restore(ParameterDescription& parameter) {
  parameter.value = *parameter.in_file;
  parameter.set_by.clear();
}

// What is wrong, at which place: values are part of messages.
bool has_error(const Diagnostics& said, const Diagnostic& one) {
  return std::ranges::any_of(said.items(), [&](const Diagnostic& other) {
    return other.severity == Severity::error && other.code == one.code && other.where == one.where;
  });
}

// What is said with some of the values of the file.
class RestoredFile {
 public:
  RestoredFile(const MechanismDescription& description, const Binding& bind)
      : description_(description), bind_(bind) {
    for (std::size_t i = 0; i < description.parameters.size(); ++i) {
      if (is_set(description.parameters[i])) {
        set_.push_back(i);
      }
    }
    MechanismDescription own = description;
    for (const std::size_t i : set_) {
      restore(own.parameters[i]);
    }
    bind(own, said_of_own_);
  }

  bool has(const Diagnostic& one) const { return has_error(said_of_own_, one); }

  // Those without each of which the error is gone; all, where it takes several.
  std::vector<const ParameterDescription*> causes_of(const Diagnostic& one) {
    if (said_without_.empty() && set_.size() > 1) {
      for (const std::size_t i : set_) {
        MechanismDescription rest = description_;
        restore(rest.parameters[i]);
        bind_(rest, said_without_.emplace_back());
      }
    }
    std::vector<const ParameterDescription*> causes;
    std::vector<const ParameterDescription*> all;
    for (std::size_t k = 0; k < set_.size(); ++k) {
      all.push_back(&description_.parameters[set_[k]]);
      if (set_.size() > 1 && !has_error(said_without_[k], one)) {
        causes.push_back(all.back());
      }
    }
    return causes.empty() ? all : causes;
  }

 private:
  const MechanismDescription& description_;
  const Binding& bind_;
  std::vector<std::size_t> set_;
  Diagnostics said_of_own_;
  std::vector<Diagnostics> said_without_;  // one of those set
};

void add_blaming(const std::vector<const ParameterDescription*>& causes,
                 const Diagnostic& one,
                 Diagnostics& found) {
  std::vector<std::string> options;
  std::vector<std::string> usual;
  for (const ParameterDescription* const cause : causes) {
    options.push_back(fmt::format("--set '{}'", printable(cause->set_by)));
    usual.push_back(fmt::format(
        "--set '{}={}'", printable(cause->name.text), cause->in_file->expression.text()));
  }
  Diagnostic& added =
      found.error("E0102",
                  {},
                  fmt::format("{}: {}", fmt::join(options, " "), one.message),
                  fmt::format("write a value like that of the file: {}", fmt::join(usual, " ")));
  added.notes.push_back({.where = one.where,
                         .message = fmt::format("its value is used here{}",
                                                one.hint.empty() ? "" : ": " + one.hint)});
  added.notes.insert(added.notes.end(), one.notes.begin(), one.notes.end());
}

void add_as_said(const Diagnostic& one, Diagnostics& found) {
  Diagnostic& added = one.severity == Severity::error
                          ? found.error(one.code, one.where, one.message, one.hint)
                          : found.warning(one.code, one.where, one.message, one.hint);
  added.notes = one.notes;
}

}  // namespace

bool has_overrides(const MechanismDescription& description) {
  return std::ranges::any_of(description.parameters, is_set);
}

void add_blaming_overrides(const MechanismDescription& description,
                           const Binding& bind,
                           const Diagnostics& said,
                           Diagnostics& found) {
  std::optional<RestoredFile> restored;
  for (const Diagnostic& one : said.items()) {
    const bool may_be_of_option = one.severity == Severity::error && one.where.line != 0;
    if (may_be_of_option && !restored) {
      restored.emplace(description, bind);
    }
    if (may_be_of_option && !restored->has(one)) {
      add_blaming(restored->causes_of(one), one, found);
    } else {
      add_as_said(one, found);
    }
  }
}

}  // namespace kinestat
