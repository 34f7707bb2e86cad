#include "studies/sweep/task/row_player.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "files/parameter_names.hpp"

namespace kinestat {

namespace {

bool is_one_of_parameters(const MechanismDescription& description,
                          const std::string& name,
                          Diagnostics& found) {
  const std::vector<std::string> names = parameter_names(description);
  const bool is_known = std::ranges::find(names, name) != names.end();
  if (!is_known) {
    found.error("E0103",
                {},
                fmt::format("the file has no parameter '{}'", printable(name)),
                parameter_hint(name, description));
  }
  return is_known;
}

// The sweep that the request stands for; its axes have one value each, that of the file.
std::optional<SweepDescription> sweep_of(const MechanismDescription& description,
                                         const RowRequest& request,
                                         Diagnostics& found) {
  SweepDescription sweep;
  for (const std::string& name : request.inputs) {
    if (!is_one_of_parameters(description, name, found)) {
      return std::nullopt;
    }
    if (std::ranges::count(request.inputs, name) > 1) {
      found.error(
          "E0103", {}, fmt::format("input '{}' is named twice", printable(name)), "name it once");
      return std::nullopt;
    }
    const auto parameter =
        std::ranges::find(description.parameters, name, [](const ParameterDescription& one) {
          return one.name.text;
        });
    VariedParameter varied;
    varied.name = {.text = name, .where = {}};
    varied.values = {parameter->value};
    sweep.vary.push_back(std::move(varied));
  }
  if (request.label) {
    sweep.cases.push_back({.text = *request.label, .where = {}});
  }
  for (const std::string& name : request.outputs) {
    sweep.report.push_back({.text = name, .where = {}});
  }
  return sweep;
}

// What is wrong with the sweep that stands for a request, and has no place in the file, is wrong
// with the request.
void refuse_request(const Diagnostics& asked, Diagnostics& found) {
  for (const Diagnostic& one : asked.items()) {
    if (one.severity == Severity::error) {
      found.error(
          one.where == SourceRange{} ? "E0103" : one.code, one.where, one.message, one.hint);
    }
  }
}

}  // namespace

std::optional<RowPlayer> RowPlayer::make(MechanismDescription description,
                                         const RowRequest& request,
                                         Diagnostics& found) {
  std::optional<SweepDescription> sweep = sweep_of(description, request, found);
  if (!sweep) {
    return std::nullopt;
  }
  description.sweep = *std::move(sweep);
  Diagnostics asked;
  std::optional<Loaded> loaded = bind_swept(std::move(description), asked);
  std::optional<SweepTask> task =
      loaded ? make_sweep_task({}, *std::move(loaded), {}, asked) : std::nullopt;
  if (!task) {
    refuse_request(asked, found);
    return std::nullopt;
  }
  if (task->cases.size() > 1) {
    std::vector<std::string> labels;
    for (const Case& one : task->cases) {
      labels.push_back(one.label);
    }
    found.error(
        "E0103",
        {},
        fmt::format("the mechanism has {} cases and gears, and one can be recorded", labels.size()),
        "name one of " + plain_list(labels));
    return std::nullopt;
  }
  return RowPlayer(std::make_unique<SweepTask>(*std::move(task)));
}

void RowPlayer::play(std::span<const double> rows,
                     std::span<double> outputs,
                     std::span<const char*> statuses) {
  if (rows.empty()) {
    return;
  }
  task_->plan.run_through(rows);
  if (!solver_) {
    task_->tapes = record_tapes(*task_);
    solver_ = std::make_unique<StateSolver>(*task_);
  }
  run(outputs, statuses);
}

void RowPlayer::run(std::span<double> outputs, std::span<const char*> statuses) {
  const std::size_t width = task_->columns.size();
  KINESTAT_EXPECTS(outputs.size() == width * task_->plan.state_count());
  StateWalk walk(task_->plan, 0, task_->plan.state_count());
  for (auto states = solver_->solve_next(walk); !states.empty();
       states = solver_->solve_next(walk)) {
    for (const SolvedState& state : states) {
      const SweepRow& row = state.rows.front();
      const auto number = static_cast<std::size_t>(state.number);
      std::ranges::copy(row.values, outputs.begin() + static_cast<std::ptrdiff_t>(number * width));
      if (!statuses.empty()) {
        statuses[number] = kept(row.status);
      }
    }
  }
}

// Words of rows are no texts of C.
const char* RowPlayer::kept(std::string_view status) {
  const auto at = statuses_.find(status);
  return (at != statuses_.end() ? at : statuses_.emplace(status).first)->c_str();
}

}  // namespace kinestat
