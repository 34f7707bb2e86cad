#include "core/diagnostic.hpp"

#include <cstddef>
#include <string>
#include <utility>

#include "core/codes.hpp"
#include "core/contract.hpp"
#include "core/utf8.hpp"

namespace kinestat {

Diagnostic& Diagnostics::error(std::string_view code,
                               SourceRange where,
                               std::string message,
                               std::string hint) {
  Diagnostic& added = add({.severity = Severity::error,
                           .code = code,
                           .where = where,
                           .message = std::move(message),
                           .hint = std::move(hint),
                           .notes = {}});
  ++error_count_;
  return added;
}

Diagnostic& Diagnostics::warning(std::string_view code,
                                 SourceRange where,
                                 std::string message,
                                 std::string hint) {
  return add({.severity = Severity::warning,
              .code = code,
              .where = where,
              .message = std::move(message),
              .hint = std::move(hint),
              .notes = {}});
}

Diagnostic& Diagnostics::add(Diagnostic one) {
  KINESTAT_EXPECTS(find_code(one.code) != nullptr);
  // A file with thousands of mistakes is answered in little memory: nobody reads so many hints.
  constexpr std::size_t kMostHintsKept = 1000;
  one.message = printable(one.message);
  one.hint = items_.size() < kMostHintsKept ? printable(one.hint) : std::string();
  items_.push_back(std::move(one));
  return items_.back();
}

}  // namespace kinestat
