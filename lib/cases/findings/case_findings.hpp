// Findings: what is wrong with the answer of one case in one position, or worth knowing of it.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cases/analysis.hpp"
#include "core/diagnostic.hpp"

namespace kinestat {

/// One finding. Findings of two positions are the same if code, place and element are equal.
struct CaseFinding {
  Severity severity = Severity::error;
  std::string_view code;  ///< a literal that core/codes lists
  SourceRange where;
  std::string message;
  std::string hint;
  std::string element = {};  ///< the element that it is about, as the message calls it
  double size = 0.0;         ///< severity: the largest finding represents several positions
};

/// Whether another position has reported a finding with this code and place. The text of a finding
/// is then left out if writing it costs more than the solution.
using IsReported = std::function<bool(std::string_view code, SourceRange where)>;

/// The findings of one case, in the order in which they were found.
class CaseFindings {
 public:
  explicit CaseFindings(IsReported is_reported = {}) : is_reported_(std::move(is_reported)) {}

  bool is_reported(std::string_view code, SourceRange where) const {
    return is_reported_ && is_reported_(code, where);
  }

  CaseFinding& error(std::string_view code,
                     SourceRange where,
                     std::string message,
                     std::string hint = {});
  CaseFinding& warning(std::string_view code,
                       SourceRange where,
                       std::string message,
                       std::string hint = {});

  void add(const CaseFinding& one) { items_.push_back(one); }

  std::span<const CaseFinding> items() const { return items_; }

 private:
  IsReported is_reported_;
  std::vector<CaseFinding> items_;
};

/// What a finding needs besides the solution: the names, places and units of the file. Holds
/// references.
struct JudgedFile {
  const MechanismDescription& description;
  const Mechanism& mechanism;
  const std::optional<ShiftAnalysis>& shift;
};

JudgedFile judged_file(const Analysis& analysis);

/// Finds everything that is wrong with the answer of a case, or worth knowing of it; nothing if the
/// case is in order. This is the only function that judges solved cases, for every pass.
CaseFindings find_case_findings(const JudgedFile& file,
                                const CaseAnalysis& one,
                                IsReported is_reported = {});

/// Adds a finding to the messages of the file.
void add(const CaseFinding& one, Diagnostics& found);

/// Adds a finding for each slip of `shift` that has no answer.
void add_slip_findings(const ShiftAnalysis& shift, Diagnostics& found);

/// Adds the findings of all cases and slips at their lines: why one was not solved, and what to
/// give instead.
void add_findings(const Analysis& analysis, Diagnostics& found);

}  // namespace kinestat
