// Tapes: a case recorded once and played for many states.
#include <algorithm>
#include <cmath>
#include <kinestat.h>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "interface/last_messages.hpp"
#include "interface/mechanism_handle.hpp"
#include "studies/sweep/task/row_player.hpp"

struct kinestat_tape {
  kinestat::RowPlayer player;
};

namespace kinestat {

namespace {

// Empty where one is missing.
std::optional<std::vector<std::string>> texts(const char* const* list,
                                              std::size_t count,
                                              std::string_view what,
                                              Diagnostics& found) {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_given(list, fmt::format("the list of {}s", what), found) ||
        !is_given(list[i], fmt::format("{} {}", what, i + 1), found)) {
      return std::nullopt;
    }
    result.emplace_back(list[i]);
  }
  return result;
}

void record(const kinestat_mechanism& mechanism,
            RowRequest request,
            kinestat_tape** tape,
            Diagnostics& found) {
  if (request.inputs.empty()) {
    refuse_argument("a tape needs an input",
                    "name the parameters whose values change from state to state",
                    found);
    return;
  }
  if (auto player = RowPlayer::make(mechanism.description, request, found)) {
    *tape = std::make_unique<kinestat_tape>(kinestat_tape{*std::move(player)}).release();
  }
}

// Whether all are numbers that a file could have.
bool are_finite(std::span<const double> rows,
                std::span<const SweepAxis> inputs,
                Diagnostics& found) {
  const auto at = std::ranges::find_if_not(rows, [](double value) { return std::isfinite(value); });
  if (at == rows.end()) {
    return true;
  }
  const auto place = static_cast<std::size_t>(at - rows.begin());
  refuse_argument(fmt::format("'{}' is {} in state {}",
                              inputs[place % inputs.size()].name(),
                              *at,
                              place / inputs.size()),
                  "give a finite number, or leave the state out",
                  found);
  return false;
}

void play(RowPlayer& player,
          const double* inputs,
          std::size_t states,
          double* outputs,
          const char** statuses,
          Diagnostics& found) {
  const std::span<const double> rows(inputs, states * player.inputs().size());
  if (are_finite(rows, player.inputs(), found)) {
    player.play(rows,
                std::span(outputs, states * player.outputs().size()),
                statuses != nullptr ? std::span(statuses, states) : std::span<const char*>());
  }
}

const SweepColumn* output_of(const kinestat_tape* tape, std::size_t output) {
  return tape != nullptr && output < tape->player.outputs().size() ? &tape->player.outputs()[output]
                                                                   : nullptr;
}

}  // namespace

}  // namespace kinestat

int kinestat_record(const kinestat_mechanism* mechanism,
                    const char* label,
                    const char* const* inputs,
                    size_t input_count,
                    const char* const* outputs,
                    size_t output_count,
                    kinestat_tape** tape) {
  return kinestat::answer_call([&](kinestat::CallMessages& messages) {
    if (!kinestat::is_given(mechanism, "the mechanism", messages.found) ||
        !kinestat::is_given(tape, "the place of the tape", messages.found)) {
      return;
    }
    messages.source = mechanism->source;
    auto input_names = kinestat::texts(inputs, input_count, "input", messages.found);
    auto output_names = kinestat::texts(outputs, output_count, "output", messages.found);
    if (input_names && output_names) {
      kinestat::record(
          *mechanism,
          {.inputs = *std::move(input_names),
           .outputs = *std::move(output_names),
           .label = label != nullptr ? std::optional<std::string>(label) : std::nullopt},
          tape,
          messages.found);
    }
  });
}

void kinestat_free_tape(kinestat_tape* tape) {
  delete tape;
}

size_t kinestat_output_count(const kinestat_tape* tape) {
  return tape != nullptr ? tape->player.outputs().size() : 0;
}

const char* kinestat_output_name(const kinestat_tape* tape, size_t output) {
  const kinestat::SweepColumn* column = kinestat::output_of(tape, output);
  return column != nullptr ? column->name.c_str() : nullptr;
}

const char* kinestat_output_unit(const kinestat_tape* tape, size_t output) {
  const kinestat::SweepColumn* column = kinestat::output_of(tape, output);
  return column != nullptr ? column->unit.c_str() : nullptr;
}

const char* kinestat_input_unit(const kinestat_tape* tape, size_t input) {
  return tape != nullptr && input < tape->player.inputs().size()
             ? tape->player.inputs()[input].unit().c_str()
             : nullptr;
}

int kinestat_play(kinestat_tape* tape,
                  const double* inputs,
                  size_t states,
                  double* outputs,
                  const char** statuses) {
  return kinestat::answer_call([&](kinestat::CallMessages& messages) {
    if (kinestat::is_given(tape, "the tape", messages.found) && states > 0 &&
        kinestat::is_given(inputs, "the list of inputs", messages.found) &&
        kinestat::is_given(outputs, "the place of the outputs", messages.found)) {
      kinestat::play(tape->player, inputs, states, outputs, statuses, messages.found);
    }
  });
}

int kinestat_is_played(const kinestat_tape* tape) {
  return tape != nullptr && tape->player.is_played() ? 1 : 0;
}
