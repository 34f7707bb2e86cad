#include "plot/page/file_section.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "plot/gear_scheme.hpp"
#include "plot/linkage_drawing.hpp"
#include "plot/motion_curves.hpp"
#include "plot/page/figures.hpp"
#include "plot/page/motion_figure.hpp"
#include "plot/page/motion_tables.hpp"
#include "plot/page/tables.hpp"
#include "plot/summary.hpp"
#include "plot/sweep_curves.hpp"
#include "report/case_text.hpp"
#include "report/diagnostic_text.hpp"
#include "report/gear_values.hpp"
#include "report/mobility_text.hpp"
#include "report/mobility_words.hpp"
#include "report/motion_text.hpp"
#include "report/shift_text.hpp"
#include "report/synthesis_text.hpp"

namespace kinestat {

namespace {

// Of the frames of two charts that stand beside each other [px].
constexpr double kChartWidth = 480.0;

// Whether a finding goes on with "   12 | ..." or "      | ^^^".
bool is_quotation(std::string_view text) {
  const std::size_t mark = text.find_first_not_of(" 0123456789");
  return mark != std::string_view::npos && text.substr(mark).starts_with('|');
}

class FileSection {
 public:
  FileSection(const FilePage& page, std::string id, PageForm form, int& figures, Html& html)
      : page_(page), id_(std::move(id)), form_(form), figures_(figures), html_(html) {}

  std::vector<PageHeading> run() {
    html_.open("section", {{"id", id_}, {"class", "file"}, {"aria-label", page_title(page_)}});
    if (form_ == PageForm::many_files) {
      html_.element("h2", page_title(page_), {{"class", "file-title"}});
    }
    add_source();
    add_summary();
    add_findings();
    add_structure();
    add_mobility();
    add_motion();
    add_shift();
    add_cases();
    add_sensitivity();
    add_sweep();
    add_synthesis();
    add_data();
    html_.close();
    return std::move(headings_);
  }

 private:
  // Opens a part of the section, which the caller closes.
  void open_part(const std::string& name, const std::string& title) {
    const std::string part = fmt::format("{}-{}", id_, name);
    headings_.push_back({.id = part, .title = title});
    html_.open("section", {{"id", part}, {"class", name}, {"aria-labelledby", part + "-title"}});
    html_.element(level(0), title, {{"id", part + "-title"}, {"class", "part-title"}});
  }

  // "h2" for a part of a page of one file, "h3" for what is a level below it.
  std::string level(int below) const {
    return fmt::format("h{}", (form_ == PageForm::one_file ? 2 : 3) + below);
  }

  void add_source() {
    if (page_.description && !page_.description->source.empty()) {
      html_.element("p", printable(page_.description->source), {{"class", "source"}});
    }
    const std::string& path = page_.source.path;
    html_.open("p", {{"class", "source"}});
    html_.element("code", path == "-" ? "<stdin>" : printable(path));
    html_.close();
  }

  void add_summary() {
    const std::vector<std::string> sentences = summary_sentences(page_);
    if (sentences.empty()) {
      return;
    }
    open_part("summary", "Summary");
    for (const std::string& one : sentences) {
      html_.element("p", one);
    }
    html_.close();
  }

  void add_findings() {
    if (page_.found.items().empty()) {
      return;
    }
    open_part("found", "Findings");
    html_.open("ul", {{"class", "findings"}});
    for (const DiagnosticText& one : diagnostic_texts(page_.source, page_.found)) {
      html_.open("li", {{"class", one.severity == Severity::error ? "error" : "warning"}});
      add_finding(one.text);
      html_.close();
    }
    html_.close();
    html_.close();
  }

  // Words are broken into lines, the line of the file with its carets is not.
  void add_finding(std::string_view text) {
    while (!text.empty()) {
      const bool is_quoted = is_quotation(text);
      std::size_t end = 0;
      while (end < text.size() && is_quotation(text.substr(end)) == is_quoted) {
        end = std::min(text.find('\n', end), text.size() - 1) + 1;
      }
      html_.open("pre", {{"class", is_quoted ? "quoted" : "words"}});
      html_.lines(text.substr(0, end));
      html_.close();
      text.remove_prefix(end);
    }
  }

  PictureSource source(std::optional<std::size_t> which = {}) const {
    return {.analysis = page_.analysis ? &*page_.analysis : nullptr,
            .motion = page_.motion ? &page_.motion->table : nullptr,
            .synthesis = page_.synthesis ? &*page_.synthesis : nullptr,
            .which = which,
            .name = page_title(page_)};
  }

  void add_pictures(const std::vector<Picture>& pictures) {
    if (pictures.empty()) {
      return;
    }
    html_.open("div", {{"class", pictures.size() == 1 ? "pictures" : "pictures two"}});
    add_figures(pictures, page_title(page_), id_, figures_, html_);
    html_.close();
  }

  // Tables, and pictures of the same beside them where there is room, else below.
  void add_pair(const TextBlocks& blocks, const std::string& name, std::vector<Picture> pictures) {
    const auto below = std::stable_partition(
        pictures.begin(), pictures.end(), [](const Picture& one) { return !is_broad(one); });
    const std::vector<Picture> beside(pictures.begin(), below);
    html_.open("div", {{"class", beside.empty() || blocks.is_empty() ? "pair" : "pair both"}});
    html_.open("div");
    add_blocks(blocks, name, html_);
    html_.close();
    if (!beside.empty()) {
      html_.open("div");
      add_figures(beside, page_title(page_), id_, figures_, html_);
      html_.close();
    }
    html_.close();
    add_pictures({below, pictures.end()});
  }

  void add_structure() {
    if (!page_.analysis) {
      return;
    }
    open_part("structure", "Structure");
    LinkageOptions plain;
    plain.shows_forces = false;
    const Picture linkage = draw_linkage(*page_.analysis, plain);
    // Of a train the half section along its axis says more than a view in space.
    const std::optional<Picture> scheme = draw_gear_scheme(*page_.analysis, {});
    std::vector<Picture> pictures = {scheme ? *scheme : linkage};
    for (Picture& one : pictures_at(PicturePlace::structure, source())) {
      pictures.push_back(std::move(one));
    }
    add_pictures(pictures);
    std::vector<Picture> graphs = pictures_at(PicturePlace::graphs, source());
    if (scheme) {
      add_folded("Drawing in space", {linkage});
    }
    add_folded("Graphs of motions and actions, circuits and cut-sets", graphs);
    html_.close();
  }

  // Below each other, behind a line that opens them.
  void add_folded(const std::string& line, const std::vector<Picture>& pictures) {
    html_.open("details");
    html_.element("summary", line);
    for (const Picture& one : pictures) {
      add_pictures({one});
    }
    html_.close();
  }

  void add_mobility() {
    if (!page_.mobility) {
      return;
    }
    open_part("mobility", "Mobility");
    for (const std::string& remark : mobility_remarks(*page_.mobility)) {
      html_.element("p", remark);
    }
    const MobilityBlocks blocks = mobility_blocks(*page_.mobility);
    add_blocks(blocks.counts, "Mobility", html_);
    if (!blocks.reshetov.is_empty()) {
      html_.open("details", {{"class", "reshetov"}});
      html_.element("summary", "Reshetov's tables: what closes each circuit without force");
      add_blocks(blocks.reshetov, "Reshetov", html_);
      html_.close();
    }
    add_blocks(blocks.motions, "Mobility", html_);
    html_.close();
  }

  // A part that the file has a section for, and that has come to nothing.
  void add_lack(const std::string& name, const std::string& title, bool is_asked) {
    if (is_asked) {
      open_part(name, title);
      html_.element("p", "There is nothing to show: the findings say what is wrong.");
      html_.close();
    }
  }

  void add_motion() {
    if (!page_.motion) {
      add_lack("motion", "Motion", page_.description && page_.description->motion);
      return;
    }
    open_part("motion", "Motion");
    const bool is_drawn = page_.analysis && !page_.motion->positions.empty();
    html_.open("div", {{"class", is_drawn ? "pair both" : "pair"}});
    if (is_drawn) {
      html_.open("div");
      add_motion_figure(*page_.analysis, *page_.motion, id_, figures_, html_);
      html_.close();
    }
    html_.open("div");
    add_motion_tables(page_.motion->table);
    html_.close();
    html_.close();
    add_charts(motion_figure(page_.motion->table, ""), "Motion");
    add_charts(path_figure(page_.motion->table, ""), "Paths of points");
    const std::size_t positions = page_.motion->table.rows.size();
    if (positions > kMostPositions) {
      html_.element("p",
                    fmt::format("The table has some of the {} positions; the file of the motion "
                                "under Data has all.",
                                positions));
    }
    if (positions > 0) {
      add_table(position_table(page_.motion->table), "Positions", html_);
    }
    html_.close();
  }

  // Each a figure of its own, so that they stand beside each other.
  void add_charts(const Figure& figure, const std::string& what) {
    std::vector<Picture> pictures;
    for (Chart chart : figure.charts) {
      chart.width = kChartWidth;
      const std::string& shown = chart.title.empty() ? chart.y.label : chart.title;
      pictures.push_back(
          draw_figure({.name = figure.name,
                       .title = fmt::format("{}, {}: {}", what, shown, page_title(page_)),
                       .description = figure.description,
                       .charts = {chart}}));
    }
    add_pictures(pictures);
  }

  void add_motion_tables(const MotionTable& motion) {
    if (!motion.label.empty()) {
      html_.element("p",
                    fmt::format("With the speeds and loads of case {}.", printable(motion.label)));
    }
    add_table(drive_table(motion), "Drives", html_);
    if (!motion.events.empty()) {
      add_table(event_table(motion), "Events", html_);
    }
    add_blocks(motion_remarks(motion), "Motion", html_);
    add_blocks(motion_extremes(motion), "Extremes", html_);
  }

  void add_shift() {
    if (!page_.analysis || !page_.analysis->shift) {
      return;
    }
    open_part("shift", "Shift table");
    add_pictures(pictures_at(PicturePlace::shift, source()));
    add_blocks(shift_blocks(*page_.analysis), "Shift table", html_);
    html_.close();
  }

  // "1: C1 + B2", the elements that a gear engages.
  std::string case_title(const CaseAnalysis& one) const {
    const std::string label = printable(one.which.label);
    if (!page_.analysis->shift) {
      return label;
    }
    const ShiftAnalysis& shift = *page_.analysis->shift;
    const auto state =
        std::ranges::find(shift.solution.states, one.which.label, &NamedShiftState::name);
    if (state == shift.solution.states.end()) {
      return label;
    }
    std::vector<std::string> elements;
    for (const int e : state->engaged) {
      const auto actuator =
          static_cast<std::size_t>(shift.plan.elements[static_cast<std::size_t>(e)].actuator);
      elements.push_back(page_.analysis->mechanism.topology.actuators[actuator].name);
    }
    return fmt::format("{}: {} engaged", label, fmt::join(elements, " and "));
  }

  std::string case_id(std::size_t index) const { return fmt::format("{}-case-{}", id_, index); }

  void add_cases() {
    if (!page_.analysis || page_.analysis->cases.empty()) {
      return;
    }
    const std::vector<CaseAnalysis>& cases = page_.analysis->cases;
    const bool are_gears = page_.analysis->shift.has_value();
    open_part("cases", are_gears ? "Gears" : "Cases");
    html_.open("div", {{"class", "chooser"}});
    if (cases.size() > 1) {
      add_choices(are_gears ? "Gear" : "Case");
    }
    for (std::size_t i = 0; i < cases.size(); ++i) {
      add_case(i);
    }
    html_.close();
    if (cases.size() > 1) {
      add_comparison(are_gears ? "All gears" : "All cases");
    }
    html_.close();
  }

  void add_comparison(const std::string& title) {
    const std::vector<Picture> pictures = pictures_at(PicturePlace::compared, source());
    if (!pictures.empty()) {
      html_.element(level(1), title, {{"class", "case-title"}});
      add_pictures(pictures);
    }
  }

  void add_choices(const std::string& what) {
    html_.open("fieldset", {{"class", "choices script"}, {"hidden", ""}});
    html_.element("legend", what);
    const std::vector<CaseAnalysis>& cases = page_.analysis->cases;
    for (std::size_t i = 0; i < cases.size(); ++i) {
      html_.open("label");
      if (i == 0) {
        html_.single(
            "input",
            {{"type", "radio"}, {"name", id_ + "-case"}, {"value", case_id(i)}, {"checked", ""}});
      } else {
        html_.single("input", {{"type", "radio"}, {"name", id_ + "-case"}, {"value", case_id(i)}});
      }
      html_.element("span", printable(cases[i].which.label));
      html_.close();
      html_.markup("\n");
    }
    html_.close();
  }

  void add_case(std::size_t index) {
    const CaseAnalysis& one = page_.analysis->cases[index];
    const CaseBlocks blocks = case_blocks(*page_.analysis, one);
    const std::string id = case_id(index);
    html_.open("section", {{"class", "panel"}, {"id", id}, {"aria-labelledby", id + "-title"}});
    html_.element(level(1), case_title(one), {{"id", id + "-title"}, {"class", "case-title"}});
    add_blocks(TextBlocks(blocks.known + blocks.ratio), "Case", html_);
    add_case_pictures(pictures_at(PicturePlace::one_case, source(index)));
    const auto add_pass = [&](const char* title, const TextBlocks& pass, PicturePlace place) {
      if (!pass.is_empty()) {
        html_.element(level(2), title, {{"class", "pass-title"}});
        add_pair(pass, title, pictures_at(place, source(index)));
      }
    };
    add_pass("Velocities", blocks.motion, PicturePlace::velocities);
    add_pass("Actions", blocks.action, PicturePlace::actions);
    add_pass("Power", blocks.power, PicturePlace::power);
    if (!blocks.affine.empty()) {
      html_.element(level(2), "Free parameters", {{"class", "pass-title"}});
      add_blocks(TextBlocks(blocks.affine), "Free parameters", html_);
    }
    html_.close();
  }

  // Of a train the section first, and its forces in space behind a line.
  void add_case_pictures(const std::vector<Picture>& pictures) {
    const auto scheme = std::ranges::find(pictures, "gear-scheme", &Picture::name);
    if (scheme == pictures.end()) {
      add_pictures(pictures);
      return;
    }
    std::vector<Picture> others;
    std::ranges::copy_if(pictures, std::back_inserter(others), [](const Picture& one) {
      return one.name != "gear-scheme";
    });
    add_pictures({*scheme});
    add_folded("Drawing in space with the forces", others);
  }

  void add_sensitivity() {
    if (page_.sensitivity.empty()) {
      return;
    }
    open_part("sensitivity", "Sensitivity");
    html_.element("p",
                  "Exact derivatives by the parameters of the file, the strongest first; relative: "
                  "by how many per cent a value moves if the parameter moves by one.");
    for (const PageSensitivity& one : page_.sensitivity) {
      const std::string label = printable(one.label);
      html_.open("details");
      html_.element("summary", label);
      add_blocks(one.blocks, "Sensitivity of " + label, html_);
      html_.close();
    }
    html_.close();
  }

  void add_sweep() {
    if (!page_.sweep) {
      add_lack("sweep", "Sweep", page_.description && page_.description->sweep);
      return;
    }
    open_part("sweep", "Sweep");
    if (const std::string lack = sweep_lack(*page_.sweep); !lack.empty()) {
      html_.element("p", fmt::format("There is no picture: {}.", lack));
    } else {
      const Figure figure = sweep_figure(*page_.sweep, "");
      html_.element("p", figure.description);
      add_charts(figure, "Sweep over " + figure.charts.front().x.label);
    }
    html_.close();
  }

  void add_synthesis() {
    if (!page_.synthesis) {
      add_lack("synthesis", "Synthesis", page_.description && page_.description->synthesis);
      return;
    }
    open_part("synthesis", "Synthesis");
    // Its tables are too wide for a picture beside them.
    add_pictures(pictures_at(PicturePlace::synthesis, source()));
    add_blocks(synthesis_blocks(*page_.synthesis), "Synthesis", html_);
    html_.close();
  }

  void add_data() {
    if (page_.data.empty()) {
      return;
    }
    open_part("data", "Data");
    html_.element("p", "Everything above with all digits, as files:");
    html_.open("ul", {{"class", "downloads script"}, {"hidden", ""}});
    for (std::size_t i = 0; i < page_.data.size(); ++i) {
      const PageData& one = page_.data[i];
      html_.open("li");
      html_.element("button",
                    one.name,
                    {{"type", "button"},
                     {"data-save", data_id(i)},
                     {"data-name", one.name},
                     {"data-type", one.type}});
      html_.close();
    }
    html_.close();
    for (std::size_t i = 0; i < page_.data.size(); ++i) {
      const bool is_json = page_.data[i].type == "application/json";
      html_.open("script",
                 {{"type", "application/json"},
                  {"id", data_id(i)},
                  {"data-kind", is_json ? "json" : "text"}});
      html_.markup(is_json ? script_json(page_.data[i].text) : script_string(page_.data[i].text));
      html_.close();
    }
    html_.close();
  }

  std::string data_id(std::size_t index) const { return fmt::format("{}-data-{}", id_, index); }

  const FilePage& page_;
  std::string id_;
  PageForm form_;
  int& figures_;
  Html& html_;
  std::vector<PageHeading> headings_;
};

}  // namespace

std::vector<PageHeading> add_file_section(
    const FilePage& page, const std::string& id, PageForm form, int& figures, Html& html) {
  return FileSection(page, id, form, figures, html).run();
}

}  // namespace kinestat
