#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cases/report/case_text.hpp"
#include "core/utf8.hpp"
#include "pages/figures.hpp"
#include "pages/page_parts.hpp"
#include "pages/tables.hpp"
#include "report/report_parts.hpp"
#include "studies/shift/report/gear_report.hpp"

namespace kinestat {

namespace {

class CasePart {
 public:
  explicit CasePart(SectionWriter& section)
      : section_(section), analysis_(*section.page().analysis), html_(section.html()) {}

  void run() {
    if (analysis_.cases.empty()) {
      return;
    }
    const std::vector<CaseAnalysis>& cases = analysis_.cases;
    const int gears = gear_count(analysis_);
    const bool are_gears = gears == static_cast<int>(cases.size());
    const bool are_both = gears > 0 && !are_gears;
    section_.open_part("cases", are_both ? "Cases and gears" : are_gears ? "Gears" : "Cases");
    html_.open("div", {{"class", "chooser"}});
    if (cases.size() > 1) {
      add_choices(are_both ? "Case or gear" : are_gears ? "Gear" : "Case");
    }
    for (std::size_t i = 0; i < cases.size(); ++i) {
      add_case(i);
    }
    html_.close();
    if (cases.size() > 1) {
      add_comparison(are_both ? "All cases and gears" : are_gears ? "All gears" : "All cases");
    }
    html_.close();
  }

 private:
  // "1: C1 + B2", the elements that a gear engages.
  std::string case_title(const CaseAnalysis& one) const {
    const std::string label = printable(one.which.label);
    if (!analysis_.shift) {
      return label;
    }
    const ShiftAnalysis& shift = *analysis_.shift;
    const auto state =
        std::ranges::find(shift.solution.states, one.which.label, &NamedShiftState::name);
    if (state == shift.solution.states.end() || state->engaged.empty()) {
      return label;
    }
    std::vector<std::string> elements;
    for (const int e : state->engaged) {
      const auto actuator =
          static_cast<std::size_t>(shift.plan.elements[static_cast<std::size_t>(e)].actuator);
      elements.push_back(analysis_.mechanism.topology.actuators[actuator].name);
    }
    std::string last = std::move(elements.back());
    elements.pop_back();
    return fmt::format("{}: {}{}{} engaged",
                       label,
                       fmt::join(elements, ", "),
                       elements.empty() ? "" : " and ",
                       last);
  }

  std::string case_id(std::size_t index) const {
    return fmt::format("{}-case-{}", section_.id(), index);
  }

  void add_comparison(const std::string& title) {
    const std::vector<Picture> pictures = pictures_at(PicturePlace::compared, section_.source());
    if (!pictures.empty()) {
      html_.element(section_.level(1), title, {{"class", "case-title"}});
      add_each(pictures);
    }
  }

  // Parts of one picture, which are called as it is, for themselves.
  void add_each(const std::vector<Picture>& pictures) {
    std::vector<Picture> whole;
    for (auto first = pictures.begin(); first != pictures.end();) {
      const auto end = std::find_if(
          first, pictures.end(), [&](const Picture& one) { return one.name != first->name; });
      if (end - first == 1) {
        whole.push_back(*first);
      } else {
        section_.add_pictures(std::exchange(whole, {}));
        section_.add_pictures({first, end});
      }
      first = end;
    }
    section_.add_pictures(whole);
  }

  void add_choices(const std::string& what) {
    html_.open("fieldset", {{"class", "choices script"}, {"hidden", ""}});
    html_.element("legend", what);
    const std::vector<CaseAnalysis>& cases = analysis_.cases;
    for (std::size_t i = 0; i < cases.size(); ++i) {
      html_.open("label");
      if (i == 0) {
        html_.single("input",
                     {{"type", "radio"},
                      {"name", section_.id() + "-case"},
                      {"value", case_id(i)},
                      {"checked", ""}});
      } else {
        html_.single("input",
                     {{"type", "radio"}, {"name", section_.id() + "-case"}, {"value", case_id(i)}});
      }
      html_.element("span", printable(cases[i].which.label));
      html_.close();
      html_.markup("\n");
    }
    html_.close();
  }

  void add_case(std::size_t index) {
    const CaseAnalysis& one = analysis_.cases[index];
    const CaseBlocks blocks = case_blocks(analysis_, one);
    const std::string id = case_id(index);
    html_.open("section", {{"class", "panel"}, {"id", id}, {"aria-labelledby", id + "-title"}});
    html_.element(section_.level(1),
                  fmt::format("{}{}", case_title(one), in_drawn_position(analysis_.description)),
                  {{"id", id + "-title"}, {"class", "case-title"}});
    html_.element("p", "Known:" + blocks.known.substr(blocks.known.find(':') + 1));
    add_blocks(TextBlocks(blocks.results), "Case", html_);
    section_.add_pictures(pictures_of_case(index));
    const auto add_pass = [&](const char* title, const TextBlocks& pass, PicturePlace place) {
      const std::vector<Picture> pictures = pictures_at(place, section_.source(index));
      if (pass.is_empty() && pictures.empty()) {
        return;
      }
      html_.element(section_.level(2), title, {{"class", "pass-title"}});
      if (pass.is_empty()) {
        section_.add_pictures(pictures);
      } else {
        section_.add_pair(pass, title, pictures);
      }
    };
    add_pass("Velocities", blocks.motion, PicturePlace::velocities);
    add_pass("Actions", blocks.action, PicturePlace::actions);
    add_pass("Power", blocks.power, PicturePlace::power);
    if (!blocks.dynamics.is_empty()) {
      html_.element(section_.level(2), "Inertia", {{"class", "pass-title"}});
      add_blocks(blocks.dynamics, "Inertia", html_);
    }
    if (!blocks.affine.empty()) {
      html_.element(section_.level(2), "Free parameters", {{"class", "pass-title"}});
      add_blocks(TextBlocks(blocks.affine), "Free parameters", html_);
    }
    html_.close();
  }

  // Of a train the section alone: seen from the front, with the forces of each gear, its wheels
  // cover each other, and pages of many gears would be a third longer.
  std::vector<Picture> pictures_of_case(std::size_t index) {
    const PictureSource source = section_.source(index);
    const PictureKind& scheme = *find_picture_kind("gear-scheme");
    if (has_picture(scheme, source)) {
      return {scheme.draw(source)};
    }
    return pictures_at(PicturePlace::one_case, source);
  }

  SectionWriter& section_;
  const Analysis& analysis_;
  Html& html_;
};

}  // namespace

int gear_count(const Analysis& analysis) {
  return static_cast<int>(std::ranges::count_if(
      analysis.cases, [](const CaseAnalysis& one) { return one.which.is_gear; }));
}

void add_case_part(SectionWriter& section) {
  CasePart(section).run();
}

}  // namespace kinestat
