#include "core/diagnostic.hpp"

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
  one.message = printable(one.message);
  one.hint = printable(one.hint);
  items_.push_back(std::move(one));
  return items_.back();
}

}  // namespace kinestat
