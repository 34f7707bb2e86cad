#include "terminal/progress_line.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>
#include <unistd.h>

#include "core/text.hpp"

namespace kinestat::app {

namespace {

std::string line_of(const Progress& progress, double seconds) {
  std::string line = std::to_string(static_cast<int>(100.0 * progress.share)) + " %, " +
                     std::to_string(progress.done) + " of " + std::to_string(progress.total) + " " +
                     progress.things + ", " + progress.result;
  const double share = progress.share - progress.known_share;
  if (seconds > 0.0 && share > 0.0) {
    const double rate = static_cast<double>(progress.done - progress.known) / seconds;
    line += ", " + std::to_string(static_cast<std::int64_t>(rate)) + " " + progress.things +
            "/s, " + duration_text((1.0 - progress.share) * seconds / share) + " left";
  }
  return line;
}

}  // namespace

ProgressLine::ProgressLine(ProgressChoice choice)
    : is_terminal_(::isatty(STDERR_FILENO) == 1), last_(begin_) {
  is_wanted_ =
      choice == ProgressChoice::always || (choice == ProgressChoice::automatic && is_terminal_);
}

void ProgressLine::show(const Progress& progress) {
  const Clock::time_point now = Clock::now();
  const auto pause = is_terminal_ ? std::chrono::milliseconds(200) : std::chrono::seconds(1);
  const bool is_last = progress.done == progress.total;
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
