#include "terminal/progress_line.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>
#include <unistd.h>

#include "core/text.hpp"

namespace kinestat::app {

namespace {

std::string line_of(const SweepProgress& progress, double seconds) {
  const auto done = static_cast<double>(progress.states - progress.resumed);
  const double rate = seconds > 0.0 ? done / seconds : 0.0;
  const double share = progress.total == 0 ? 1.0
                                           : static_cast<double>(progress.states) /
                                                 static_cast<double>(progress.total);
  std::string line = std::to_string(static_cast<int>(100.0 * share)) + " %, " +
                     std::to_string(progress.states) + " of " + std::to_string(progress.total) +
                     " states, " + std::to_string(progress.rows) + " rows";
  if (rate > 0.0) {
    const double left = static_cast<double>(progress.total - progress.states) / rate;
    line += ", " + std::to_string(static_cast<std::int64_t>(rate)) + " states/s, " +
            duration_text(left) + " left";
  }
  return line;
}

}  // namespace

ProgressLine::ProgressLine(ProgressChoice choice)
    : is_terminal_(::isatty(STDERR_FILENO) == 1), last_(begin_) {
  is_wanted_ =
      choice == ProgressChoice::always || (choice == ProgressChoice::automatic && is_terminal_);
}

void ProgressLine::show(const SweepProgress& progress) {
  const Clock::time_point now = Clock::now();
  const auto pause = is_terminal_ ? std::chrono::milliseconds(200) : std::chrono::seconds(1);
  const bool is_last = progress.states == progress.total;
  if (has_shown_ && !is_last && now - last_ < pause) {
    return;
  }
  last_ = now;
  has_shown_ = true;
  std::string line = line_of(progress, std::chrono::duration<double>(now - begin_).count());
  const std::size_t length = line.size();
  line.resize(std::max(line.size(), is_terminal_ ? width_ : 0), ' ');
  width_ = length;
  std::fprintf(stderr, is_terminal_ ? "\r%s" : "%s\n", line.c_str());
  std::fflush(stderr);
}

void ProgressLine::finish() {
  if (has_shown_ && is_terminal_) {
    std::fputc('\n', stderr);
  }
}

}  // namespace kinestat::app
