#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "draw/linkage/page_linkage.hpp"
#include "draw/train/gear_scheme.hpp"
#include "pages/figures.hpp"
#include "pages/page_parts.hpp"
#include "pages/tables.hpp"
#include "studies/mobility/report/mobility_text.hpp"
#include "studies/mobility/report/mobility_words.hpp"
#include "studies/shift/report/shift_text.hpp"
#include "studies/sweep/picture/sweep_curves.hpp"
#include "studies/synthesis/report/synthesis_text.hpp"
#include "studies/transmissions/picture/ladders.hpp"

namespace kinestat {

namespace {

class FileSection {
 public:
  FileSection(const FilePage& page, std::string id, PageForm form, int& figures, Html& html)
      : page_(page), section_(page, std::move(id), form, figures, html), html_(html) {
    if (page.analysis) {
      LinkageOptions plain;
      plain.shows_forces = false;
      if (has_picture(*find_picture_kind("linkage"), section_.source())) {
        linkage_ = draw_page_linkage(*page.analysis, plain);
      }
      scheme_ =
          draw_gear_scheme(*page.analysis, {.which = {}, .sections = section_.source().sections});
    }
  }

  std::vector<PageHeading> run() {
    html_.open("section",
               {{"id", section_.id()}, {"class", "file"}, {"aria-label", page_title(page_)}});
    if (section_.form() == PageForm::many_files) {
      html_.element("h2", page_title(page_), {{"class", "file-title"}});
    }
    add_source();
    // Whatever else is shown, errors come first.
    if (page_.found.has_errors()) {
      add_found();
      add_summary_part(section_, main_picture());
    } else {
      add_summary_part(section_, main_picture());
      add_found();
    }
    add_motion_part(section_);
    add_simulation_part(section_);
    add_shift();
    if (page_.analysis) {
      add_case_part(section_);
    }
    add_duty();
    add_sensitivity();
    add_sweep();
    add_synthesis();
    add_structure();
    add_mobility();
    add_data();
    html_.close();
    return section_.take_headings();
  }

 private:
  void add_found() {
    if (page_.found.items().empty()) {
      return;
    }
    section_.open_part("found", "Findings");
    add_findings(page_.source, page_.found, html_);
    html_.close();
  }

  // Of a train the section along its axis says more than a view in space.
  const std::optional<Picture>& main_picture() const { return scheme_ ? scheme_ : linkage_; }

  void add_source() {
    if (page_.description && !page_.description->source.empty()) {
      html_.element("p", "Source: " + printable(page_.description->source), {{"class", "source"}});
    }
    const std::string& path = page_.source.path;
    html_.open("p", {{"class", "source"}});
    html_.element("code", path == "-" ? "<stdin>" : printable(path));
    html_.close();
  }

  void add_structure() {
    if (!page_.analysis) {
      return;
    }
    section_.open_part("structure", "Structure");
    std::vector<Picture> pictures = pictures_at(PicturePlace::structure, section_.source());
    const bool moves = has_drawn_motion(page_) || has_drawn_simulation(page_);
    if (moves && main_picture()) {
      pictures.insert(pictures.begin(), *main_picture());
    }
    section_.add_pictures(pictures);
    if (scheme_ && linkage_) {
      section_.add_folded("Drawing in space", {*linkage_});
    }
    section_.add_folded("Graphs of motions and actions, circuits and cut-sets",
                        pictures_at(PicturePlace::graphs, section_.source()));
    html_.close();
  }

  void add_mobility() {
    if (!page_.mobility) {
      return;
    }
    section_.open_part("mobility", "Mobility");
    const MobilityBlocks blocks = mobility_blocks(*page_.mobility);
    add_blocks(blocks.counts, "Mobility", html_);
    const std::vector<std::string> remarks = mobility_remarks(*page_.mobility);
    if (!remarks.empty()) {
      html_.open("details");
      html_.element("summary", "How the counts are related");
      for (const std::string& remark : remarks) {
        html_.element("p", remark);
      }
      html_.close();
    }
    add_folded_blocks(
        "Reshetov's tables: what closes each circuit without force", "Reshetov", blocks.reshetov);
    add_folded_blocks(
        "Motions, redundant constraints, and remedies", "Motions and constraints", blocks.motions);
    html_.close();
  }

  void add_folded_blocks(const std::string& line, const char* name, const TextBlocks& blocks) {
    if (blocks.is_empty()) {
      return;
    }
    html_.open("details");
    html_.element("summary", line);
    add_blocks(blocks, name, html_);
    html_.close();
  }

  void add_shift() {
    if (!page_.analysis || !page_.analysis->shift) {
      return;
    }
    section_.open_part("shift", "Shift table");
    section_.add_pictures(pictures_at(PicturePlace::shift, section_.source()));
    const ShiftBlocks shift = shift_parts(*page_.analysis, ShownOthers::all);
    add_blocks(shift.gears, "Shift table", html_);
    add_folded_blocks(fmt::format("{} of elements {} no gear",
                                  counted(shift.other_count, "combination"),
                                  shift.other_count == 1 ? "gives" : "give"),
                      "No gear",
                      shift.others);
    add_blocks(shift.elements, "Elements", html_);
    html_.close();
  }

  void add_duty() {
    if (!page_.duty) {
      section_.add_lack("duty", "Duty", page_.description && page_.description->duty);
      return;
    }
    section_.open_part("duty", "Duty");
    section_.add_pair(
        page_.duty->blocks, "Duty", pictures_at(PicturePlace::duty, section_.source()));
    html_.close();
  }

  bool is_gear(const std::string& label) const {
    return std::ranges::any_of(page_.analysis->cases, [&](const CaseAnalysis& one) {
      return one.which.is_gear && one.which.label == label;
    });
  }

  void add_sensitivity() {
    if (page_.sensitivity.empty()) {
      return;
    }
    section_.open_part("sensitivity", "Sensitivity");
    html_.element("p",
                  "Exact derivatives by the parameters of the file, the strongest first; relative: "
                  "by how many per cent a value moves if the parameter moves by 1 %.");
    for (const PageSensitivity& one : page_.sensitivity) {
      const std::string label = printable(one.label);
      html_.open("details");
      html_.element("summary", (is_gear(one.label) ? "Gear " : "Case ") + label);
      add_blocks(one.blocks, "Sensitivity of " + label, html_);
      html_.close();
    }
    html_.close();
  }

  void add_sweep() {
    if (!page_.sweep) {
      section_.add_lack("sweep", "Sweep", page_.description && page_.description->sweep);
      return;
    }
    section_.open_part("sweep", "Sweep");
    if (const std::string why_not = why_no_curves_of_sweep(*page_.sweep); !why_not.empty()) {
      html_.element("p", fmt::format("There is no picture: {}.", why_not));
    } else {
      const Figure figure = sweep_figure(*page_.sweep, "");
      html_.element("p", figure.description);
      section_.add_charts(figure, "Sweep over " + figure.charts.front().x.label);
    }
    html_.close();
  }

  void add_transmissions() {
    section_.open_part("synthesis", "Synthesis");
    section_.add_pictures(pictures_at(PicturePlace::synthesis, section_.source()));
    if (!page_.transmissions->groups.empty()) {
      section_.add_charts(trade_off_figure(*page_.transmissions), "Trade-offs");
    }
    if (!page_.schemes.empty()) {
      html_.element("p", "Gear schemes of the best ladders, of each its first transmission:");
      section_.add_pictures(page_.schemes);
    }
    add_blocks(transmission_blocks(*page_.transmissions), "Synthesis", html_);
    html_.close();
  }

  void add_synthesis() {
    if (page_.transmissions) {
      add_transmissions();
      return;
    }
    if (!page_.synthesis) {
      section_.add_lack(
          "synthesis", "Synthesis", page_.description && page_.description->synthesis);
      return;
    }
    section_.open_part("synthesis", "Synthesis");
    // Its tables are too wide for a picture beside them.
    section_.add_pictures(pictures_at(PicturePlace::synthesis, section_.source()));
    add_blocks(synthesis_blocks(*page_.synthesis), "Synthesis", html_);
    html_.close();
  }

  void add_data() {
    if (page_.data.empty()) {
      return;
    }
    section_.open_part("data", "Data");
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

  std::string data_id(std::size_t index) const {
    return fmt::format("{}-data-{}", section_.id(), index);
  }

  const FilePage& page_;
  SectionWriter section_;
  Html& html_;
  std::optional<Picture> linkage_;
  std::optional<Picture> scheme_;
};

}  // namespace

std::vector<PageHeading> add_file_section(
    const FilePage& page, const std::string& id, PageForm form, int& figures, Html& html) {
  return FileSection(page, id, form, figures, html).run();
}

}  // namespace kinestat
