#include "core/diagnostic.hpp"

#include <utility>

#include "core/codes.hpp"
#include "core/contract.hpp"

namespace kinestat {

Diagnostic& Diagnostics::error(std::string_view code,
                               SourceRange where,
                               std::string message,
                               std::string hint) {
  KINESTAT_EXPECTS(find_code(code) != nullptr);
  ++error_count_;
  items_.push_back({.severity = Severity::error,
                    .code = code,
                    .where = where,
                    .message = std::move(message),
                    .hint = std::move(hint),
                    .notes = {}});
  return items_.back();
}

Diagnostic& Diagnostics::warning(std::string_view code,
                                 SourceRange where,
                                 std::string message,
                                 std::string hint) {
  KINESTAT_EXPECTS(find_code(code) != nullptr);
  items_.push_back({.severity = Severity::warning,
                    .code = code,
                    .where = where,
                    .message = std::move(message),
                    .hint = std::move(hint),
                    .notes = {}});
  return items_.back();
}

}  // namespace kinestat
