#include "pages/moving_figure.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "pages/figures.hpp"

namespace kinestat {

namespace {

std::vector<std::string> script_strings(const std::vector<std::string>& texts) {
  std::vector<std::string> strings;
  for (const std::string& text : texts) {
    strings.push_back(script_string(text));
  }
  return strings;
}

std::string steps_json(const std::vector<std::vector<DrawnPose>>& steps) {
  std::vector<std::string> lines;
  for (const std::vector<DrawnPose>& poses : steps) {
    std::vector<std::string> numbers;
    for (const DrawnPose& pose : poses) {
      for (const double value : pose) {
        numbers.push_back(fmt::format("{:.9g}", value));
      }
    }
    lines.push_back(fmt::format("[{}]", fmt::join(numbers, ",")));
  }
  return fmt::format("{}", fmt::join(lines, ",\n"));
}

std::string motion_json(const MovingFigure& figure) {
  return fmt::format(R"({{"drawn":{},"closed":{},"bodies":[{}],"labels":[{}],"rows":[{}],{})"
                     "\n"
                     R"("poses":[{}]}})",
                     figure.drawn,
                     figure.is_closed,
                     fmt::join(script_strings(figure.bodies), ","),
                     fmt::join(script_strings(figure.labels), ","),
                     fmt::join(figure.rows, ","),
                     figure.acting.empty() ? "" : figure.acting + ",",
                     steps_json(figure.steps));
}

// Play, single steps, slider and speed; a script adds what depends on the data.
void add_controls(const MovingFigure& figure, Html& html) {
  constexpr auto kSpeeds = std::to_array<std::pair<std::string_view, std::string_view>>(
      {{"0.25", "¼"}, {"0.5", "½"}, {"1", "1"}, {"2", "2"}, {"4", "4"}});
  const auto first = static_cast<std::size_t>(std::max(figure.drawn, 0));
  html.open("div", {{"class", "drive script"}, {"hidden", ""}});
  html.element("button", "Play", {{"type", "button"}, {"data-play", ""}});
  html.element(
      "button", "−", {{"type", "button"}, {"data-step", "-1"}, {"aria-label", "One step back"}});
  html.element(
      "button", "+", {{"type", "button"}, {"data-step", "1"}, {"aria-label", "One step on"}});
  html.single("input",
              {{"type", "range"},
               {"min", "0"},
               {"max", fmt::format("{}", figure.labels.size() - 1)},
               {"step", "1"},
               {"value", fmt::format("{}", first)},
               {"aria-label", figure.what}});
  html.element("output", figure.labels[first]);
  html.open("label");
  html.text("Speed ");
  html.open("select", {{"data-speed", ""}});
  for (const auto& [value, shown] : kSpeeds) {
    const std::string text = fmt::format("{} ×", shown);
    if (value == "1") {
      html.element("option", text, {{"value", std::string(value)}, {"selected", ""}});
    } else {
      html.element("option", text, {{"value", std::string(value)}});
    }
  }
  html.close();
  html.close();
  html.close();
}

}  // namespace

void open_moving_figure(const Picture& picture, const MovingFigure& figure, Html& html) {
  const bool moves = figure.labels.size() > 1;
  const std::string poses = figure.section + "-poses";
  if (moves) {
    html.open("figure",
              {{"class", "motion"},
               {"data-picture", figure.name},
               {"data-motion", figure.section},
               {"data-poses", poses},
               {"data-autoplay", ""}});
  } else {
    html.open("figure", {{"data-picture", figure.name}});
  }
  add_picture(picture, fmt::format("{}-figure-{}", figure.section, figure.number), html);
  if (moves) {
    add_controls(figure, html);
  }
  add_caption(figure.number, figure.caption, html);
  if (moves) {
    html.open("script", {{"type", "application/json"}, {"id", poses}});
    html.markup(script_json(motion_json(figure)));
    html.close();
  }
}

}  // namespace kinestat
