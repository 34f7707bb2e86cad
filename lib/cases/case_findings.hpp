// What there is to say of the answer of one case in one position.
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

/// One thing to say. Code, place and element tell whether two positions say the same.
struct CaseFinding {
  Severity severity = Severity::error;
  std::string_view code;  ///< a literal that core/codes lists
  SourceRange where;
  std::string message;
  std::string hint;
  std::string element = {};  ///< which of several at that place, as the message has it
  double size = 0.0;         ///< how bad: the largest stands for several positions
};

/// Whether another position has said what has this code and place, so that its words, where they
/// cost more than the solution, are left out.
using IsReported = std::function<bool(std::string_view code, SourceRange where)>;

/// Collects them, in the order in which they were found.
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

/// What a finding is told from beside the solution: the names, places and units of the file. Holds
/// references.
struct JudgedFile {
  const MechanismDescription& description;
  const Mechanism& mechanism;
  const std::optional<ShiftAnalysis>& shift;
};

JudgedFile judged_file(const Analysis& analysis);

/// Everything that is wrong with the answer of a case, or to be known of it: the one judge of
/// solved cases, for every pass. Nothing of a case that is in order.
CaseFindings find_case_findings(const JudgedFile& file,
                                const CaseAnalysis& one,
                                IsReported is_reported = {});

/// Adds them to the messages of the file.
void add(const CaseFinding& one, Diagnostics& found);

/// Of slips without an answer.
void add_slip_findings(const ShiftAnalysis& shift, Diagnostics& found);

/// The findings of all cases, and of slips, at the lines of these: why one was not solved, and what
/// to give instead.
void add_findings(const Analysis& analysis, Diagnostics& found);

}  // namespace kinestat
