#include "mechanism/motion_figure.hpp"

#include <algorithm>
#include <vector>

namespace kinestat {

std::string_view word_of(MotionFigure figure) {
  switch (figure) {
    case MotionFigure::least:
      return "least";
    case MotionFigure::greatest:
      return "greatest";
    case MotionFigure::range:
      return "range";
    case MotionFigure::mean:
      return "mean";
    case MotionFigure::rms:
      return "rms";
    case MotionFigure::peak:
      return "peak";
    case MotionFigure::dead_points:
      return "dead_points";
    case MotionFigure::overall_efficiency:
      return "overall_efficiency";
  }
  return "";
}

std::span<const std::string> motion_figure_words() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> result;
    for (int i = 0; i <= static_cast<int>(MotionFigure::overall_efficiency); ++i) {
      result.emplace_back(word_of(static_cast<MotionFigure>(i)));
    }
    return result;
  }();
  return words;
}

std::optional<MotionFigureName> motion_figure_of(std::string_view name) {
  const std::size_t dot = name.find_last_of("./");
  const std::string_view last = dot == std::string_view::npos ? name : name.substr(dot + 1);
  const auto words = motion_figure_words();
  const auto at = std::ranges::find(words, last);
  if (at == words.end()) {
    return std::nullopt;
  }
  const auto figure = static_cast<MotionFigure>(at - words.begin());
  const bool is_of_whole = figure == MotionFigure::overall_efficiency;
  if (dot == std::string_view::npos) {
    return figure == MotionFigure::dead_points || is_of_whole
               ? std::optional(MotionFigureName{.column = {}, .figure = figure})
               : std::nullopt;
  }
  return is_of_whole ? std::nullopt
                     : std::optional(MotionFigureName{.column = std::string(name.substr(0, dot)),
                                                      .figure = figure});
}

bool sweeps_motion_alone(const MechanismDescription& description) {
  return description.motion && description.sweep && !description.sweep->report.empty() &&
         std::ranges::all_of(description.sweep->report, [](const Name& name) {
           return motion_figure_of(name.text).has_value();
         });
}

}  // namespace kinestat
