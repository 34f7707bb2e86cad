#include "studies/duty/task/find_duty.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"
#include "io/read_file.hpp"
#include "mechanism/duty/duty_table.hpp"

namespace kinestat {

namespace {

// A cycle of a line a tenth of a second for a day has so many bytes.
constexpr std::size_t kMostTableBytes = std::size_t{1} << 26U;

void add_table(const std::string& path,
               const MechanismDescription& description,
               const Mechanism& mechanism,
               DutyPlan& plan,
               Diagnostics& found) {
  const auto source = read_file(path, ReadLimits::for_size(kMostTableBytes), found);
  if (source) {
    add_duty_table(description, mechanism, path, source->text, plan, found);
  }
}

// Empty iff an error was added.
std::optional<DutyPlan> find_plan(const std::string& path,
                                  const JudgedFile& file,
                                  Diagnostics& found) {
  const int errors_before = found.error_count();
  std::optional<DutyPlan> plan = bind_duty(file.description, file.mechanism, found);
  if (const std::optional<Name>& table = file.description.duty->file; plan && table) {
    const auto folder = std::filesystem::path(path).parent_path();
    add_table((folder / table->text).string(), file.description, file.mechanism, *plan, found);
  }
  return found.error_count() == errors_before ? std::move(plan) : std::nullopt;
}

// The table stands for all points of the section, whose exponents and repetitions count.
std::optional<DutyPlan> find_plan_of_table(const std::string& table,
                                           const JudgedFile& file,
                                           Diagnostics& found) {
  const int errors_before = found.error_count();
  MechanismDescription description = file.description;
  if (!description.duty) {
    description.duty.emplace();
  }
  description.duty->points.clear();
  std::optional<DutyPlan> plan = bind_duty(description, file.mechanism, found);
  if (plan) {
    add_table(table, description, file.mechanism, *plan, found);
  }
  return found.error_count() == errors_before ? std::move(plan) : std::nullopt;
}

// Why points have no answer is what an analysis of their case says.
void add_unanswered(const JudgedFile& file, const DutySolution& duty, Diagnostics& found) {
  for (const UnansweredCase& one : duty.unanswered) {
    const CaseFindings findings = find_case_findings(file, one.analysis);
    for (const CaseFinding& finding : findings.items()) {
      add(finding, found);
    }
  }
}

// What an analysis says of points that have an answer: each finding where it is worst, with the
// number of points that were analysed and have it.
class PointFindings {
 public:
  void add(std::size_t point, const CaseFindings& findings) {
    for (const CaseFinding& one : findings.items()) {
      const auto at = std::ranges::find_if(held_, [&](const Held& other) {
        return other.worst.code == one.code && other.worst.where == one.where &&
               other.worst.element == one.element;
      });
      if (at == held_.end()) {
        held_.push_back({.worst = one, .point = point});
        continue;
      }
      ++at->count;
      if (one.size > at->worst.size) {
        at->worst = one;
        at->point = point;
      }
    }
  }

  void tell(const DutyPlan& plan, Diagnostics& found) const {
    for (const Held& one : held_) {
      CaseFinding told = one.worst;
      const std::string place = place_of(plan, one.point);
      told.message +=
          one.count == 1
              ? fmt::format(" ({})", place)
              : fmt::format(" ({}, and {} more)", place, counted(one.count - 1, "point"));
      kinestat::add(told, found);
    }
  }

 private:
  struct Held {
    CaseFinding worst;
    std::size_t point = 0;  // index into the plan
    int count = 1;
  };

  std::vector<Held> held_;
};

}  // namespace

std::optional<FoundDuty> find_duty(const std::string& path,
                                   const std::string& table,
                                   const JudgedFile& file,
                                   Diagnostics& found) {
  if (!file.description.duty && table.empty()) {
    found.error("E0303",
                {},
                "the file has no section 'duty'",
                "add duty: {points: [{case: …, input_motion: …, input_action: …, duration: …}]}, "
                "or give a table of points with --cycle");
    return std::nullopt;
  }
  std::optional<DutyPlan> plan =
      table.empty() ? find_plan(path, file, found) : find_plan_of_table(table, file, found);
  if (!plan) {
    return std::nullopt;
  }
  PointFindings points;
  DutySolution solution =
      solve_duty(file.mechanism, *plan, [&](std::size_t point, const CaseAnalysis& analysis) {
        points.add(point, find_case_findings(file, analysis));
      });
  points.tell(*plan, found);
  add_unanswered(file, solution, found);
  return FoundDuty{.plan = *std::move(plan), .solution = std::move(solution)};
}

}  // namespace kinestat
